// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map as files and as a scene.
#include <traverse/formats/occupancy_image.h>
#include <traverse/formats/safe_file.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>
#include <traverse/observations/convert.h>
#include <traverse/rendering/layer_surface.h>

#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/stock_objects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace traverse::maps
{
namespace
{
/** More cells than this are not drawn at once: a triangle takes 108 bytes. */
constexpr int32_t kMostDrawnHalf = 1000;

constexpr std::array<mrpt::img::TColor, 6> kPointColours = {
    mrpt::img::TColor(230, 120, 20), mrpt::img::TColor(20, 150, 90),
    mrpt::img::TColor(60, 90, 220),  mrpt::img::TColor(190, 40, 170),
    mrpt::img::TColor(0, 160, 190),  mrpt::img::TColor(150, 110, 40)};

geometry::CellRect drawnPart(const geometry::CellRect& region)
{
  const geometry::CellIndex c{
      region.min.x + region.width() / 2, region.min.y + region.height() / 2};
  const int32_t half = std::min(kMostDrawnHalf, region.width() / 2 + 1);
  return {
      {std::max(region.min.x, c.x - half), std::max(region.min.y, c.y - half)},
      {std::min(region.max.x, c.x + half), std::min(region.max.y, c.y + half)}};
}

bool isIn(const multi_lidar_grid::State& state, const Eigen::Vector3d& p)
{
  constexpr double kMost_m = 1e7;  // so far cells have indices
  return p.allFinite() && p.cwiseAbs().maxCoeff() < kMost_m &&
         state.cells.region().contains(
             state.lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y())));
}

/** Cells that nobody saw get no height, others where the ground is not known the robot's. Returns
 * the lowest. */
float fillGround(layers::LayerSet& set, float level_m)
{
  const auto layer = std::find_if(
      set.layers.begin(), set.layers.end(),
      [](const layers::Layer& l) { return l.name == "ground_height"; });
  const auto& codes = std::get<std::vector<uint8_t>>(set.find(set.class_layer)->data);
  auto& heights = std::get<std::vector<float>>(layer->data);
  float lowest = level_m;
  for (size_t i = 0; i < heights.size(); ++i)
  {
    heights[i] = std::isfinite(heights[i]) ? heights[i] : level_m;
    lowest = std::min(lowest, heights[i]);
    heights[i] = codes[i] != 0 ? heights[i] : std::numeric_limits<float>::quiet_NaN();
  }
  return lowest;
}

/** What nobody saw, as one sheet below all else: a region is mostly that. */
mrpt::opengl::CSetOfTriangles::Ptr unknownSheet(const layers::LayerSet& set, float height_m)
{
  layers::LayerSet sheet;
  sheet.lattice.cell_mm = set.lattice.cell_mm * set.extent.width();
  sheet.extent = {{0, 0}, {1, 1}};
  sheet.class_layer = "unknown";
  sheet.legend = set.legend;
  sheet.layers.push_back({"unknown", "1", std::vector<uint8_t>{0}});
  sheet.layers.push_back({"height", "m", std::vector<float>{height_m}});
  auto object = rendering::layerSurface(sheet, "height");
  object->setLocation(
      set.lattice.edge_m(set.extent.min.x), set.lattice.edge_m(set.extent.min.y), 0);
  return object;
}
}  // namespace

void CWrappableMultiLidarGrid::getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const
{
  if (!genericMapParams.enableSaveAs3DObject || isEmpty())
  {
    return;
  }
  layers::LayerSet set = layerSet(drawnPart(state_.cells.region()));
  const Eigen::Isometry3d& T_map_base = state_.robot->T_map_base;
  const double level_m = T_map_base.translation().z() - made_for_.base_height_m;
  const float lowest_m = fillGround(set, static_cast<float>(level_m));
  if (renderOptions.show_unknown)
  {
    constexpr float kBelow_m = 0.1F;
    scene.insert(unknownSheet(set, lowest_m - kBelow_m));
  }
  scene.insert(rendering::layerSurface(set, "ground_height"));
  if (renderOptions.show_points)
  {
    drawPoints(scene);
  }
  if (renderOptions.show_axes)
  {
    auto axes = mrpt::opengl::stock_objects::CornerXYZSimple(2.0F, 3.0F);
    axes->setPose(observations::toPose3D(T_map_base));
    scene.insert(axes);
  }
}

void CWrappableMultiLidarGrid::drawPoints(mrpt::opengl::CSetOfObjects& scene) const
{
  size_t colour = 0;
  for (const multi_lidar_grid::Sensor& sensor : state_.sensors.all())
  {
    const auto found = latest_points_.find(sensor.label);
    const mrpt::img::TColor& shown = kPointColours[colour++ % kPointColours.size()];
    if (found == latest_points_.end() ||
        !multi_lidar_grid::counts(multi_lidar_grid::healthOf(sensor, state_.now, made_with_)))
    {
      continue;
    }
    auto cloud = mrpt::opengl::CPointCloud::Create();
    cloud->setColor_u8(shown);
    cloud->setPointSize(2.0F);
    const Eigen::Isometry3d& pose = found->second.T_map_base;
    cloud->setPose(observations::toPose3D(pose));
    for (size_t i = 0; i < found->second.x.size(); ++i)
    {
      const LatestPoints& all = found->second;
      const Eigen::Vector3d p = pose * Eigen::Vector3d(all.x[i], all.y[i], all.z[i]);
      if (isIn(state_, p))
      {
        cloud->insertPoint(all.x[i], all.y[i], all.z[i]);
      }
    }
    scene.insert(cloud);
  }
}

void CWrappableMultiLidarGrid::saveMore(
    const std::string& prefix, const layers::LayerSet& set) const
{
  const std::string name = std::filesystem::path(prefix).filename().string();
  const formats::OccupancyImage image =
      formats::occupancyOfClasses(set, name + ".pgm", {set.blocked_codes, {0}});
  formats::writeFile(prefix + ".pgm", image.pgm);
  formats::writeFile(prefix + ".yaml", image.yaml);
}
}  // namespace traverse::maps
