// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/pose2.h>

namespace traverse::app
{
/** The window of the costmap around the vehicle, in whole cells. */
geometry::CellRect around(
    const geometry::Pose2& pose, const geometry::Lattice& lattice, double window_m);

/** The window in a map's own cells, all that touch it. */
geometry::CellRect windowOf(
    const geometry::CellRect& extent, const geometry::Lattice& from, const geometry::Lattice& to);
}  // namespace traverse::app
