// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>
#include <traverse/sensors/pinhole.h>

#include <cstdint>
#include <span>
#include <string>

namespace traverse::points
{
/** A picture beside a depth image; a view that owns nothing. */
struct ColourImage
{
  sensors::Pinhole camera;
  /** Takes points of the camera's optical frame to the depth sensor's frame. */
  Eigen::Isometry3d T_sensor_camera = Eigen::Isometry3d::Identity();
  std::span<const uint8_t> bytes;
  size_t row_bytes = 0;
  int channels = 3;  //!< 1 grey, 3 blue green red
};

/** A depth image; a view that owns nothing. Sensor frame: x along the optical axis, y left, z up.
 */
struct DepthImage
{
  TimeNs stamp = 0;
  std::string sensor_label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  sensors::Pinhole camera;
  std::span<const uint16_t> values;  //!< row-major, camera.rows x camera.columns; 0: no reading
  double unit_m = 0.001;
  bool along_axis = true;  //!< values are depths along the axis, not distances
  int step = 1;            //!< takes every step-th pixel of every step-th row
  RangeLimits limits;
  const ColourImage* colour = nullptr;
};

/** Points (with colour, where a picture was given: black outside it) and the range image, whose
 * row 0 is the lowest one of the picture and whose column 0 is the rightmost.
 *
 * A value of 0 says nothing (too near, too dark, no texture): rejected, not "no return". Throws
 * std::invalid_argument where sizes do not fit or a camera is not valid. */
Decoded decodeDepth(const DepthImage& input);
}  // namespace traverse::points
