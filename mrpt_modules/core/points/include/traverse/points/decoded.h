// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/range_image.h>
#include <traverse/points/scan.h>

#include <limits>

namespace traverse::points
{
/** Ranges outside are rejected as below_range or beyond_range; metres from the sensor. */
struct RangeLimits
{
  float min_m = 0.0F;
  float max_m = std::numeric_limits<float>::infinity();
};

/** The two products of one observation, made once and shared by all maps. */
struct Decoded
{
  ScanBuffer scan;   //!< every valid return (both, of a dual-return sensor)
  RangeImage image;  //!< empty (rows 0) where the observation has no such order
  RejectCounts rejects;

  /** The scan with its image, where there is one. */
  Scan view() const
  {
    Scan shown = scan.view();
    shown.image = image.rows > 0 ? &image : nullptr;
    return shown;
  }
};
}  // namespace traverse::points
