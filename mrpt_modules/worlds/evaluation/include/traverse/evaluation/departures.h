// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/ghosts.h>
#include <traverse/evaluation/outlines.h>

#include <vector>

namespace traverse::evaluation
{
/** Where all moving things are at a time. */
struct MovingFrame
{
  double time_s = 0;
  std::vector<Polygon> outlines;  //!< convex; those of no area are left out
};

/** When cells of the window are left, and when something comes there again. A cell is covered where
 * its square touches an outline (to half a cell's diagonal), from a frame on until the next one. In
 * the order of their times. Throws std::invalid_argument where times do not grow, and
 * std::length_error for outlines too large or too many to go through. */
std::vector<Departure> departuresOf(
    const std::vector<MovingFrame>& frames,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window);
}  // namespace traverse::evaluation
