// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map as a scene.
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/observations/convert.h>
#include <traverse/rendering/layer_surface.h>

#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/stock_objects.h>

#include <cmath>
#include <limits>

namespace traverse::maps
{
namespace
{
/** More cells than this are not drawn at once: a triangle takes 108 bytes. */
constexpr int32_t kMostDrawnSide = 2000;

geometry::CellRect drawnPart(
    const geometry::CellRect& extent,
    const geometry::Lattice& lattice,
    const std::optional<poses::StampedPose>& robot)
{
  const bool fits = int64_t{extent.max.x} - extent.min.x <= kMostDrawnSide &&
                    int64_t{extent.max.y} - extent.min.y <= kMostDrawnSide;
  if (fits || !robot)
  {
    return extent;
  }
  const Eigen::Vector3d p = robot->T_map_base.translation();
  const geometry::CellIndex c =
      lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
  constexpr int32_t kHalf = kMostDrawnSide / 2;
  return {{c.x - kHalf, c.y - kHalf}, {c.x + kHalf, c.y + kHalf}};
}

void hideUndefined(layers::LayerSet& set)
{
  const auto& classes = std::get<std::vector<uint8_t>>(set.find(set.class_layer)->data);
  for (layers::Layer& layer : set.layers)
  {
    if (layer.name != "height_mean")
    {
      continue;
    }
    auto& heights = std::get<std::vector<float>>(layer.data);
    for (size_t i = 0; i < heights.size(); ++i)
    {
      heights[i] = classes[i] == 0 ? std::numeric_limits<float>::quiet_NaN() : heights[i];
    }
  }
}
}  // namespace

void CTraversabilityGridMap::getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const
{
  if (!genericMapParams.enableSaveAs3DObject || isEmpty())
  {
    return;
  }
  const geometry::CellRect extent = traversability_grid::extentOf(state_, insertionOptions);
  layers::LayerSet set = layerSet(drawnPart(extent, state_.lattice, state_.robot));
  if (!renderOptions.show_undefined)
  {
    hideUndefined(set);
  }
  scene.insert(rendering::layerSurface(set, "height_mean"));
  if (renderOptions.show_axes && state_.robot)
  {
    auto axes = mrpt::opengl::stock_objects::CornerXYZSimple(2.0F, 3.0F);
    axes->setPose(observations::toPose3D(state_.robot->T_map_base));
    scene.insert(axes);
  }
}
}  // namespace traverse::maps
