// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "velodyne_firing.h"
#include "velodyne_turn.h"

#include <traverse/points/range_image.h>

#include <array>

namespace traverse::points
{
/** Where the beams of a turn stand in its range image.
 *
 * A laser that looks to the side sees now what the others see later, so its row is moved by the
 * whole number of columns nearest to its azimuth offset: neighbours in the image are neighbours in
 * space. A turn that closes is moved round; otherwise the image is widened, and where no laser
 * fired it says rejected, with azimuth and elevation NaN. */
class VelodyneImage
{
 public:
  VelodyneImage(const VelodyneBeams& beams, const ColumnPlan& plan, int lasers, RangeImage& image);

  /** Place of a record's beam; sequence counts from the first firing of the turn. */
  size_t indexOf(const VelodyneBeam& beam, size_t record, int sequence) const
  {
    int along = sequence + shift_[record] + behind_;  // in the direction of the turn
    if (closes_)
    {
      along += along < 0 ? sequences_ : 0;
      along -= along >= sequences_ ? sequences_ : 0;
    }
    return image_.index(beam.ring, image_.columns - 1 - along);
  }

  bool has(int sequence) const { return sequence < sequences_; }

  /** The cells below may be kNoCell: a beam behind the first turn. */
  static constexpr size_t kNoCell = static_cast<size_t>(-1);

  /** Says where and when a cell's beam looked. */
  void aim(size_t cell, const Firing& firing);

  /** Says what a beam met; a hit stays a hit, whatever its other return is. */
  void mark(size_t cell, Beam kind);

  /** The nearer hit of a beam counts. */
  void hit(size_t cell, const Firing& firing, double distance_m, const std::array<double, 3>& p);

 private:
  int sequences_;
  bool closes_;
  int behind_ = 0;  // columns added for lasers that look back
  std::array<int, sensors::kVelodyneRecords> shift_{};
  RangeImage& image_;
};

/** Velodyne's clockwise azimuth, 0..kUnitsPerTurn-1, as atan2(y, x), -pi..pi. */
float counterClockwise(sensors::AzimuthUnits azimuth);
}  // namespace traverse::points
