// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/occupancy_state.h>
#include <traverse/multi_lidar_grid/params.h>

#include <cstdint>
#include <span>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** Widths of the adaptive safety buffer, m. */
struct BufferParams
{
  double cell_size_m = 0.2;
  double hard_m = 1.8;
  double soft_m = 1.2;
  StripRule strip = StripRule::standard;
};

/** The adaptive safety buffer around obstacles and negative obstacles of a dense grid of `columns`
 * cells a row (codes of layers::OccupancyState): codes of layers::BufferZone. Obstacle cells
 * themselves are `hard`; unknown cells grow no buffer, have none, and are no part of a strip.
 * Throws std::invalid_argument where the number of states is no multiple of the columns. */
std::vector<uint8_t> safetyBuffer(
    std::span<const uint8_t> states, int32_t columns, const BufferParams& params);
}  // namespace traverse::multi_lidar_grid
