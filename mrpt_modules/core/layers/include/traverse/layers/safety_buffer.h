// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/occupancy_state.h>
#include <traverse/options/option.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace traverse::layers
{
/** Where a cell between two obstacles is as far from one as from the other. */
enum class StripRule : uint8_t
{
  standard,  //!< "default": the directions to the nearest obstacle jump there
  paper,     //!< the Laplacian of the distances is strongly negative there
  none,      //!< soft buffers stay whole
};

/** Widths of the adaptive safety buffer, m. */
struct BufferParams
{
  double cell_size_m = 0.2;
  double hard_m = 1.8;
  double soft_m = 1.2;
  StripRule strip = StripRule::standard;
};

/** The adaptive safety buffer around obstacles and negative obstacles of a dense grid of `columns`
 * cells a row (codes of OccupancyState): codes of BufferZone, by distances from the
 * middle of a cell to that of the nearest obstacle. Obstacle cells themselves are `hard`; unknown
 * cells grow no buffer, have none, and are no part of a strip.
 *
 * A strip (StripRule::standard) hangs together by the cells' sides along corridors that are 2 cells
 * wider than the vehicle, and lies about a cell from their middle at most; it is led on until
 * buffers no longer meet, and left out where it is shorter than wide and leads nowhere.
 *
 * Throws std::invalid_argument where the number of states is no multiple of the columns, a width is
 * not of 0 to 1000 m, or reaches more than 16382 cells. */
std::vector<uint8_t> safetyBuffer(
    std::span<const uint8_t> states, int32_t columns, const BufferParams& params);
}  // namespace traverse::layers

template <>
struct traverse::options::EnumNames<traverse::layers::StripRule>
{
  using E = traverse::layers::StripRule;
  static constexpr std::array<std::pair<E, std::string_view>, 3> kNames = {
      {{E::standard, "default"}, {E::paper, "paper"}, {E::none, "none"}}};
};
