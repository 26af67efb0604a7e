// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace traverse::evaluation
{
/** The obstacle cells of a map at a time. */
struct ObstacleFrame
{
  double time_s = 0;
  std::vector<geometry::CellIndex> obstacles;  //!< any order
};

/** A moving thing has left a cell. */
struct Departure
{
  geometry::CellIndex cell;
  double left_s = 0;
  double again_s = std::numeric_limits<double>::infinity();  //!< when something comes there again
};

/** How long cells stay obstacles when what was there has left. */
struct GhostScore
{
  std::vector<double>
      seconds;  //!< of each departure that a frame came after, ascending; 0: no ghost
  uint64_t never_cleared = 0;  //!< of them, still there in the last frame (or when something came
                               //!< again): they count with the time until then
  uint64_t unseen = 0;         //!< departures without a frame behind them

  double mean_s() const;  //!< NaN where there are none
  double percentile_s(
      double share) const;  //!< smallest time that so many (0..1) do not exceed; NaN
};

/** Frames in the order of time, otherwise std::invalid_argument. A ghost ends with the first frame
 * at or after left_s in which its cell is no obstacle. */
GhostScore ghostScore(
    const std::vector<ObstacleFrame>& frames, const std::vector<Departure>& departures);
}  // namespace traverse::evaluation
