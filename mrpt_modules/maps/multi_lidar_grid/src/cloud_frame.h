// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_points.h"
#include "rules.h"

#include <traverse/geometry/lattice.h>
#include <traverse/multi_lidar_grid/cloud.h>

namespace traverse::multi_lidar_grid
{
/** How a cloud's points fall into a region's cells. Heights count from a whole 100 m near the
 * vehicle. */
BeamFrame frameOf(
    const Cloud& cloud,
    const SensorParams& sensor,
    const geometry::CellRect& region,
    const Rules& rules);

/** The sensor at a time of the scan, m from the region's corner and the heights' zero. */
Eigen::Vector3f localOrigin(const Cloud& cloud, const BeamFrame& frame, float time_s);
}  // namespace traverse::multi_lidar_grid
