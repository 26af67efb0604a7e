// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace traverse::layers
{
/** What a cell is to a vehicle; the codes of layers called occupancy_state, a contract with
 * everybody who reads our files. */
enum class OccupancyState : uint8_t
{
  unknown = 0,   //!< nobody looked
  free = 1,      //!< looked at so low that nothing higher than the obstacle height stands there
  obstacle = 2,  //!< something stands there, lower than the vehicle's height
  negative = 3,  //!< the ground falls away: ditch, hole
  overhang = 4,  //!< free, and something hangs above the vehicle's height
};

/** What a cell is to a path; the codes of layers called safety_buffer (paper 5). */
enum class BufferZone : uint8_t
{
  none = 0,
  soft = 1,   //!< near an obstacle: not planned through, but may be driven
  hard = 2,   //!< the vehicle would touch: no planning, no driving
  strip = 3,  //!< would be soft, and is as far from one obstacle as from another: may be planned
};
}  // namespace traverse::layers
