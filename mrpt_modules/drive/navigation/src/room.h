// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>

#include <cstdint>

namespace traverse::navigation
{
/** From the middle of a cell to that of the nearest hard buffer or obstacle, m; infinity where none
 * is within reach (of a square). */
double roomAt(const Costmap& costmap, geometry::CellIndex c, int32_t reach_cells);
}  // namespace traverse::navigation
