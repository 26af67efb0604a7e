// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/occupancy_state.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace traverse::layers
{
/** A grid and its buffer, of which strips are cut; rows of `columns` cells. */
struct Buffer
{
  std::span<const uint8_t> states;  //!< codes of OccupancyState
  std::span<uint8_t> zones;         //!< codes of BufferZone
  size_t columns = 1;

  /** Or strip of what would be soft. */
  bool isSoft(size_t cell) const
  {
    return zones[cell] != static_cast<uint8_t>(BufferZone::none) &&
           zones[cell] != static_cast<uint8_t>(BufferZone::hard);
  }

  /** By one of its sides. */
  bool isBesideFree(size_t cell) const
  {
    bool found = false;
    forEachNeighbour(
        cell,
        [&](size_t next)
        {
          found |= zones[next] == static_cast<uint8_t>(BufferZone::none) &&
                   states[next] != static_cast<uint8_t>(OccupancyState::unknown);
        });
    return found;
  }

  /** f(cell) for the neighbours by sides. */
  template <class F>
  void forEachNeighbour(size_t cell, F&& f) const
  {
    const size_t x = cell % columns;
    if (cell >= columns)
    {
      f(cell - columns);
    }
    if (x > 0)
    {
      f(cell - 1);
    }
    if (x + 1 < columns)
    {
      f(cell + 1);
    }
    if (cell + columns < zones.size())
    {
      f(cell + columns);
    }
  }

  /** The neighbours across corners. */
  template <class F>
  void forEachCorner(size_t cell, F&& f) const
  {
    forEachNeighbour(
        cell,
        [&](size_t side)
        {
          const bool is_in_column = side + columns == cell || side == cell + columns;
          const size_t x = side % columns;
          if (is_in_column && x > 0)
          {
            f(side - 1);
          }
          if (is_in_column && x + 1 < columns)
          {
            f(side + 1);
          }
        });
  }
};
}  // namespace traverse::layers
