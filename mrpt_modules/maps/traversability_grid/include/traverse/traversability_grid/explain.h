// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/scan_consumer.h>
#include <traverse/traversability_grid/state.h>

#include <vector>

namespace traverse::traversability_grid
{
/** Why the cell is what it is, for people: its square, class and index, the options and values that
 * decided, its features, and the sums of each of its slabs. Also of a cell that was never seen. */
std::vector<layers::Fact> explain(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    geometry::CellIndex cell);
}  // namespace traverse::traversability_grid
