// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>
#include <traverse/sensors/velodyne.h>

#include <span>
#include <string>

namespace traverse::points
{
/** The packets of one turn, as they came, and where the sensor sits. */
struct VelodyneInput
{
  std::span<const sensors::VelodynePacket> packets;           //!< untrusted bytes
  const sensors::VelodyneCalibration* calibration = nullptr;  //!< nullptr: the model's own table
  TimeNs stamp = 0;  //!< of the first firing of the first good packet
  std::string sensor_label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  RangeLimits limits;
};

/** Decodes packets of a VLP-16, HDL-32E or VLP-32C; never throws for what they hold.
 *
 * Sensor frame: azimuth 0 is x, growing azimuth turns towards -y (Velodyne counts clockwise), z is
 * up. The azimuth of a beam is that of its own firing time. A point's time comes from the packets'
 * own clock (the hour's wrap is undone); where that jumps by more than a second, a packet is placed
 * right behind its predecessor. Points are in the packets' order. Dual mode yields both returns
 * where they differ in distance: last, then strongest.
 *
 * rejects: bad_packet counts packets (none of a known sensor's, of another model than the first
 * good one, or all of them where the calibration does not fit the model); no_return counts beams
 * (both returns missing in dual mode); below_range, beyond_range and nonfinite count returns.
 *
 * image: the first turn, at most 360 degrees of the packets. One column per firing sequence, the
 * last firing first, so that azimuth grows counter-clockwise; lasers that look to the side (the
 * VLP-32C's) are moved by whole columns to where they look. Of dual returns the nearer one within
 * the limits. Beyond the longest range is no_return, below the shortest rejected. */
Decoded decodeVelodyne(const VelodyneInput& input);
}  // namespace traverse::points
