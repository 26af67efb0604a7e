// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"
#include "settings.h"

#include <traverse/common_app/map_set.h>
#include <traverse/formats/output_folder.h>
#include <traverse/formats/report.h>
#include <traverse/poses/pose_track.h>
#include <traverse/rendering/offscreen.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace traverse::app
{
/** The file with the run's own ini (configIni()). */
inline constexpr const char* kConfigFile = "config.ini";

/** The file with a map's archive. */
std::string archiveName(const BuiltMap& map);

/** Where a run writes. Pictures need no display; where none can be made (no EGL), that is a warning
 * in the metrics, and layers, archive and report are written all the same. */
class Outputs
{
 public:
  /** Throws formats::FileError where the folder cannot be written, or is there and may not be
   * replaced. */
  Outputs(const Settings& settings, RunMetrics& metrics);

  /** Numbered pictures, and classes where they are asked for, of all maps as they are at a time of
   * the log. */
  void snapshot(
      const std::vector<BuiltMap>& maps, const poses::PoseTrack& track, poses::TimeNs time);

  /** Layers, archives, pictures, scenes, report and, last, metrics.json; then the folder takes its
   * name. */
  void finish(
      const std::vector<BuiltMap>& maps, const poses::PoseTrack& track, poses::TimeNs last_stamp);

  const std::filesystem::path& folder() const { return folder_.finalPath(); }

 private:
  void write(const std::string& name, const std::string& bytes);
  /** All layers; of a map too large for that, those of a window around the robot, and a problem is
   * noted. */
  layers::LayerSet layersOf(const BuiltMap& map, const poses::PoseTrack& track, poses::TimeNs time);
  void writeSnapshotClasses(const BuiltMap& map, const poses::PoseTrack& track, poses::TimeNs time);
  void writeLayers(const BuiltMap& map, const layers::LayerSet& set);
  /** Files of the map's own (its octree), and what it warns of. */
  void writeExtras(const BuiltMap& map);
  void writePictures(
      const BuiltMap& map,
      const layers::LayerSet& set,
      const poses::PoseTrack& track,
      poses::TimeNs time);
  void addPicture(const std::string& file, const std::string& caption, std::string png);
  rendering::SceneContent sceneOf(
      const BuiltMap& map, const poses::PoseTrack& track, poses::TimeNs time) const;
  rendering::PictureSize pictureSize() const;

  /** Runs `draw` where pictures are wanted; a machine that cannot draw costs a warning, not the
   * run. */
  void drawn(const std::function<void()>& draw);

  const Settings& settings_;
  RunMetrics& metrics_;
  formats::OutputFolder folder_;
  std::vector<formats::Picture> pictures_;  // of the map that is being written
  std::optional<poses::TimeNs> last_snapshot_;
  int snapshots_ = 0;
};
}  // namespace traverse::app
