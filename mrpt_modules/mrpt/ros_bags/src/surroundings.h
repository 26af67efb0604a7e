// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "notes.h"
#include "preview.h"

#include <mrpt/img/TCamera.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>

#include <map>
#include <optional>
#include <set>
#include <string>

namespace traverse::ros_bags
{
/** Where a message stands. */
struct Origin
{
  std::string topic;
  int64_t stamp_ns = 0;  //!< of its header; of the recording where that has none
};

/** What conversions need beside the message. */
class Surroundings
{
 public:
  Surroundings(Preview preview, Notes& notes) : preview_(std::move(preview)), notes_(notes) {}

  /** Pose of a frame on the vehicle; identity, and a warning, where tf does not say. */
  mrpt::poses::CPose3D sensorPose(const std::string& frame, int64_t stamp_ns);

  /** A label for the sensor behind a topic, fit for file names and lists: letters, digits, '.',
   * '_', '-'; different for different topics. */
  std::string label(const std::string& topic);

  /** Calibration of the camera that a topic of images belongs to, for images of this size: of
   * `camera_info` beside it. Rectified images (by their topic's name) have no distortion. */
  std::optional<mrpt::img::TCamera> camera(
      const std::string& image_topic, uint32_t width, uint32_t height);

  void setCamera(const std::string& topic, const CameraInfo& info);

  /** What to divide a topic's intensities by to have them within 0..1: 1, 255 or 65535, the
   * smallest that held so far. */
  float intensityScale(const std::string& topic, const std::vector<float>& values);

  bool spatialOdometry(const std::string& topic) const { return preview_.spatial.count(topic) > 0; }

  Notes& notes() { return notes_; }

 private:
  Preview preview_;
  Notes& notes_;
  std::map<std::string, std::string> labels_;  // by topic
  std::set<std::string> taken_;                // labels
  std::map<std::string, float> scales_;        // by topic
};
}  // namespace traverse::ros_bags
