// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/range_image.h>
#include <traverse/points/scan.h>

namespace traverse::points
{
/** The raster of a spherical projection. */
struct OrganiseGrid
{
  int rows = 64;
  int columns = 1024;
};

/** A range image of a cloud without rings: spherical projection about the sensor's origin, rows
 * between the lowest and the highest elevation of the cloud, columns over the full turn; of several
 * points in one beam the nearest is kept. A beam without a point is rejected, not "no return": a
 * list of points does not say what was not met. Empty where the cloud is. Throws
 * std::invalid_argument for a grid without cells or beyond 2^24 of them. */
RangeImage organise(const Scan& scan, const OrganiseGrid& grid = {});
}  // namespace traverse::points
