// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "exports.h"
#include "report_page.h"

#include <traverse/formats/geotiff.h>
#include <traverse/formats/occupancy_image.h>
#include <traverse/formats/png.h>
#include <traverse/formats/trajectory.h>
#include <traverse/rendering/offscreen.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
/** The folder to write, with the folders above it made. */
const std::filesystem::path& withParents(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::absolute(folder).parent_path(), error);
  return folder;  // where that failed, OutputFolder says what is wrong
}
}  // namespace

std::string archiveName(const BuiltMap& map)
{
  return "map" + map.file_suffix + ".traverse";
}

Outputs::Outputs(const Settings& settings, RunMetrics& metrics) :
    settings_(settings),
    metrics_(metrics),
    folder_(
        withParents(settings.output),
        settings.force ? formats::Overwrite::replace : formats::Overwrite::refuse)
{
  metrics.title = titleOf(settings);
}

void Outputs::write(const std::string& name, const std::string& bytes)
{
  folder_.write(name, bytes);
  metrics_.files.push_back(name);
}

void Outputs::writeLayers(const BuiltMap& map, const layers::LayerSet& set)
{
  for (const layers::Layer& layer : set.layers)
  {
    write(fmt::format("{}{}.tif", layer.name, map.file_suffix), formats::geoTiff(set, layer));
  }
  const std::string class_name = set.class_layer + map.file_suffix;
  const formats::OccupancyImage classes =
      formats::occupancyOfClasses(set, class_name + ".pgm", {set.blocked_codes, {0}});
  write(class_name + ".pgm", classes.pgm);
  write(class_name + ".yaml", classes.yaml);
  if (const layers::Layer* index = set.find("traversability_index"))
  {
    const std::string name = index->name + map.file_suffix;
    const formats::OccupancyImage image = formats::occupancyOfIndex(set, *index, name + ".pgm");
    write(name + ".pgm", image.pgm);
    write(name + ".yaml", image.yaml);
  }
}

void Outputs::writeExtras(const BuiltMap& map)
{
  for (const layers::ExtraFile& file : map.consumer->extraFiles())
  {
    write("map" + map.file_suffix + file.ending, file.bytes);
  }
  for (const std::string& warning : map.consumer->warnings())
  {
    metrics_.warnings.push_back(map.title() + ": " + warning);
  }
}

rendering::SceneContent Outputs::sceneOf(
    const BuiltMap& map, const poses::PoseTrack& track, poses::TimeNs time) const
{
  rendering::SceneContent content;
  content.maps = {map.map.get()};
  if (const auto pose = track.at(time))
  {
    content.T_map_base = pose->T_map_base;
  }
  if (track.moves())
  {
    for (const poses::StampedPose& p : track.poses())
    {
      if (p.time <= time)
      {
        content.trajectory.push_back(p.T_map_base.translation());
      }
    }
  }
  return content;
}

void Outputs::addPicture(const std::string& file, const std::string& caption, std::string png)
{
  write(file, png);
  pictures_.push_back({std::move(png), caption, false});
}

rendering::PictureSize Outputs::pictureSize() const
{
  const int width = settings_.run.picture_width_px;
  return {width, width * 3 / 4};
}

void Outputs::snapshot(
    const std::vector<BuiltMap>& maps, const poses::PoseTrack& track, poses::TimeNs time)
{
  const double every_s = settings_.run.snapshot_every_s;
  if (every_s <= 0 || (last_snapshot_ && poses::secondsBetween(*last_snapshot_, time) < every_s))
  {
    return;
  }
  last_snapshot_ = time;
  ++snapshots_;
  metrics_.times.during(
      "pictures",
      [&]
      {
        for (const BuiltMap& map : maps)
        {
          drawn(
              [&]
              {
                const formats::Raster picture =
                    rendering::renderTopView(sceneOf(map, track, time), {}, pictureSize());
                write(
                    fmt::format("snapshot{}_{:04}.png", map.file_suffix, snapshots_),
                    formats::png(picture));
              });
        }
      });
  for (const BuiltMap& map : maps)
  {
    metrics_.times.during("snapshots", [&] { writeSnapshotClasses(map, track, time); });
  }
}

void Outputs::writeSnapshotClasses(
    const BuiltMap& map, const poses::PoseTrack& track, poses::TimeNs time)
{
  if (!settings_.run.snapshot_classes)
  {
    return;
  }
  const layers::LayerSet set = layersOf(map, track, time);
  const layers::Layer* classes = set.find(set.class_layer);
  if (set.extent.empty() || classes == nullptr)
  {
    return;
  }
  const std::string name = fmt::format("snapshot{}_{:04}_class.tif", map.file_suffix, snapshots_);
  write(name, formats::geoTiff(set, *classes));
  metrics_.snapshots.push_back({archiveName(map), name, poses::secondsBetween(0, time)});
}

void Outputs::writePictures(
    const BuiltMap& map,
    const layers::LayerSet& set,
    const poses::PoseTrack& track,
    poses::TimeNs time)
{
  const rendering::SceneContent content = sceneOf(map, track, time);
  const rendering::Overlay overlay{map.name, set.legend, true};
  drawn(
      [&]
      {
        const formats::Raster top = rendering::renderTopView(content, overlay, pictureSize());
        addPicture(
            fmt::format("map_top{}.png", map.file_suffix), "Seen from above, north up.",
            formats::png(top));
        const formats::Raster view = rendering::renderPerspective(content, overlay, pictureSize());
        addPicture(
            fmt::format("map_3d{}.png", map.file_suffix), "In perspective.", formats::png(view));
      });
  if (settings_.run.scene)
  {
    write(fmt::format("map{}.3Dscene", map.file_suffix), rendering::sceneFile(content));
  }
}

layers::LayerSet Outputs::layersOf(
    const BuiltMap& map, const poses::PoseTrack& track, poses::TimeNs time)
{
  try
  {
    return map.consumer->layerSet();
  }
  catch (const std::length_error& e)
  {
    constexpr int32_t kHalf = 2000;
    const geometry::Lattice lattice = latticeOf(map);
    const auto pose = track.at(time);
    const Eigen::Vector3d p =
        pose ? Eigen::Vector3d(pose->T_map_base.translation()) : Eigen::Vector3d::Zero();
    const geometry::CellIndex c =
        lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
    metrics_.complete = false;
    const std::string problem = fmt::format(
        "{}: {}; layers and pictures show {} cells around the robot, the archive has all", map.name,
        e.what(), 2 * kHalf);
    if (std::find(metrics_.problems.begin(), metrics_.problems.end(), problem) ==
        metrics_.problems.end())
    {
      metrics_.problems.push_back(problem);
    }
    return map.consumer->layerSet(
        geometry::CellRect{{c.x - kHalf, c.y - kHalf}, {c.x + kHalf, c.y + kHalf}});
  }
}

void Outputs::finish(
    const std::vector<BuiltMap>& maps, const poses::PoseTrack& track, poses::TimeNs last_stamp)
{
  std::vector<formats::Section> sections;
  const Path_m path = trajectoryOf(track);
  for (size_t i = 0; i < maps.size(); ++i)
  {
    const BuiltMap& map = maps[i];
    metrics_.times.during("write", [&] { write(archiveName(map), map.consumer->archive()); });
    metrics_.times.during("write", [&] { writeExtras(map); });
    const layers::LayerSet set =
        metrics_.times.during("layers", [&] { return layersOf(map, track, last_stamp); });
    metrics_.maps[i].cells_by_class = layers::cellsByClass(set);
    if (set.extent.empty())
    {
      metrics_.warnings.push_back(
          metrics_.maps[i].name + ": the map is empty, so it has no layers and pictures");
      continue;
    }
    metrics_.times.during("write", [&] { writeLayers(map, set); });
    metrics_.times.during(
        "exports",
        [&]
        {
          writeExports(
              settings_.run, map.file_suffix, {set, path},
              [&](const std::string& name, const std::string& bytes) { write(name, bytes); });
        });
    metrics_.times.during("pictures", [&] { writePictures(map, set, track, last_stamp); });
    sections.push_back(metrics_.times.during(
        "report",
        [&] {
          return mapSection(metrics_.maps[i], {set, path}, std::move(pictures_));
        }));
    pictures_.clear();
  }
  if (track.moves())
  {
    const std::span<const poses::StampedPose> all = track.poses();
    write("trajectory.tum", formats::tumTrajectory({all.begin(), all.end()}));
  }
  write(kConfigFile, configIni(settings_));
  write("report.html", reportPage(settings_, metrics_, std::move(sections)));
  metrics_.files.emplace_back("metrics.json");
  folder_.write("metrics.json", toJson(metrics_));
  folder_.commit();
}

void Outputs::drawn(const std::function<void()>& draw)
{
  if (!settings_.run.pictures)
  {
    return;
  }
  try
  {
    draw();
  }
  catch (const rendering::RenderError& e)
  {
    const std::string warning = fmt::format("no pictures: {}", e.what());
    if (std::find(metrics_.warnings.begin(), metrics_.warnings.end(), warning) ==
        metrics_.warnings.end())
    {
      metrics_.warnings.push_back(warning);
    }
  }
}
}  // namespace traverse::app
