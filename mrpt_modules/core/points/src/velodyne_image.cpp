// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::points
{
namespace
{
constexpr sensors::AzimuthUnits kHalfTurn = sensors::kUnitsPerTurn / 2;

/** Columns that a laser looks ahead, in the direction of the turn (clockwise). */
int shiftOf(const VelodyneBeam& beam, const ColumnPlan& plan, int sequences_per_group)
{
  const int offset = beam.azimuth_offset > kHalfTurn ? beam.azimuth_offset - sensors::kUnitsPerTurn
                                                     : beam.azimuth_offset;
  const int step = plan.step_hundredths_deg * sensors::kUnitsPerHundredth;
  if (step <= 0)
  {
    return 0;
  }
  const double columns = static_cast<double>(offset) * sequences_per_group / step;
  const int limit = plan.sequences;  // an absurd offset must not make an absurd image
  return std::clamp(static_cast<int>(std::lround(columns)), -limit, limit);
}
}  // namespace

VelodyneImage::VelodyneImage(
    const VelodyneBeams& beams, const ColumnPlan& plan, int lasers, RangeImage& image) :
    sequences_(plan.sequences), closes_(plan.closes), image_(image)
{
  int ahead = 0;
  int behind = 0;
  for (size_t i = 0; i < beams.size(); ++i)
  {
    shift_[i] = shiftOf(beams[i], plan, sensors::kVelodyneRecords / lasers);
    ahead = std::max(ahead, shift_[i]);
    behind = std::max(behind, -shift_[i]);
  }
  behind_ = closes_ ? 0 : behind;
  image_.rows = plan.sequences > 0 ? lasers : 0;
  image_.columns = plan.sequences > 0 ? plan.sequences + (closes_ ? 0 : ahead + behind) : 0;
  image_.closes = closes_;
  const size_t size = static_cast<size_t>(image_.rows) * static_cast<size_t>(image_.columns);
  image_.beam.assign(size, Beam::rejected);
  image_.range_m.assign(size, std::numeric_limits<float>::quiet_NaN());
  image_.azimuth_rad.assign(size, std::numeric_limits<float>::quiet_NaN());
  image_.elevation_rad.assign(size, std::numeric_limits<float>::quiet_NaN());
  image_.time_s.assign(size, 0);
}

void VelodyneImage::aim(size_t cell, const Firing& firing)
{
  image_.azimuth_rad[cell] = counterClockwise(firing.azimuth);
  image_.elevation_rad[cell] = firing.beam.elevation_rad;
  image_.time_s[cell] = firing.time_s;
}

void VelodyneImage::mark(size_t cell, Beam kind)
{
  if (cell != kNoCell && image_.beam[cell] != Beam::hit)
  {
    image_.beam[cell] = kind;
  }
}

void VelodyneImage::hit(
    size_t cell, const Firing& firing, double distance_m, const std::array<double, 3>& p)
{
  if (cell == kNoCell)
  {
    return;
  }
  const bool off_centre = firing.beam.has_offsets;
  const double range_m =
      off_centre ? std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) : distance_m;
  if (image_.beam[cell] == Beam::hit && image_.range_m[cell] <= static_cast<float>(range_m))
  {
    return;
  }
  image_.beam[cell] = Beam::hit;
  image_.range_m[cell] = static_cast<float>(range_m);
  if (off_centre)
  {
    // From libm, so these two may differ in the last bit between processors; points do not.
    image_.azimuth_rad[cell] = static_cast<float>(std::atan2(p[1], p[0]));
    image_.elevation_rad[cell] = static_cast<float>(std::asin(p[2] / range_m));
  }
}

float counterClockwise(sensors::AzimuthUnits azimuth)
{
  const sensors::AzimuthUnits turned =
      azimuth >= kHalfTurn ? sensors::kUnitsPerTurn - azimuth : -azimuth;
  return static_cast<float>(turned * sensors::kRadPerUnit);
}
}  // namespace traverse::points
