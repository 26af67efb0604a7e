// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/cloud_file.h>
#include <traverse/importing/source.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Geometry>

#include <filesystem>
#include <memory>
#include <string>

// Observations made of what files hold.
namespace traverse::importing
{
/** Whose observation, where its sensor sits, and when. */
struct SensorAt
{
  std::string label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  poses::TimeNs stamp = 0;
};

/** How a cloud's numbers become points of the sensor. */
struct CloudFrame
{
  Eigen::Isometry3d T_sensor_file = Eigen::Isometry3d::Identity();
  double intensity_scale = 1;  //!< to 0..1
};

/** What takes intensities to 0..1, by the largest of a cloud: fractions, bytes or 16 bits. */
double intensityScale(const formats::CloudFile& cloud);

/** CObservationPointCloud with intensities (CPointsMapXYZI), or colours (CColouredPointsMap).
 * Points that are not finite are left out, with their channels. */
Entry cloudEntry(
    const formats::CloudFile& cloud, const SensorAt& sensor, const CloudFrame& frame = {});

/** CObservationRobotPose: the vehicle in the map. */
Entry poseEntry(const poses::StampedPose& pose, const std::string& label = "POSE");

/** A pinhole camera. */
struct Camera
{
  double fx = 0;
  double fy = 0;
  double cx = 0;
  double cy = 0;
};

/** CObservationImage, stored inside; T_base_sensor has the camera's z forward and y down. Throws
 * ImportError where the picture cannot be read, or is too large to be one. */
Entry imageEntry(const std::filesystem::path& file, const SensorAt& sensor, const Camera& camera);

/** Pictures of an RGB-D camera. */
struct DepthFrame
{
  std::filesystem::path depth;   //!< 16 bits
  std::filesystem::path colour;  //!< empty: none
  double metres_per_count = 0.001;
  Camera camera;
};

/** CObservation3DRangeScan with everything inside; T_base_sensor has x forward and z up. Throws
 * ImportError. */
Entry depthEntry(const DepthFrame& frame, const SensorAt& sensor);
}  // namespace traverse::importing
