// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "map_set.h"
#include "metrics.h"
#include "settings.h"

#include <traverse/formats/output_folder.h>
#include <traverse/poses/pose_track.h>

#include <string>
#include <vector>

namespace traverse::app
{
/** Pictures made during a run, for the report: file name and PNG bytes. */
struct Picture
{
  std::string file;
  std::string caption;
  std::string png;
};

/** Where a run writes. Pictures need no display; where none can be made (no EGL), that is a warning
 * in the metrics, and layers, archive and report are written all the same. */
class Outputs
{
 public:
  Outputs(const Settings& settings, RunMetrics& metrics);

  /** Numbered pictures of all maps as they are at a time of the log. */
  void snapshot(
      const std::vector<BuiltMap>& maps, const poses::PoseTrack& track, poses::TimeNs time);

  /** Layers, archives, pictures, scenes, report and, last, metrics.json; then the folder takes its
   * name. */
  void finish(
      const std::vector<BuiltMap>& maps, const poses::PoseTrack& track, poses::TimeNs last_stamp);

  const std::filesystem::path& folder() const { return folder_.finalPath(); }

 private:
  void write(const std::string& name, const std::string& bytes);
  void writeLayers(const BuiltMap& map, const layers::LayerSet& layers);
  void writePictures(
      const BuiltMap& map,
      const layers::LayerSet& layers,
      const poses::PoseTrack& track,
      poses::TimeNs time);
  void addPicture(const std::string& file, const std::string& caption, std::string png);

  const Settings& settings_;
  RunMetrics& metrics_;
  formats::OutputFolder folder_;
  std::vector<Picture> pictures_;
  int snapshots_ = 0;
};
}  // namespace traverse::app
