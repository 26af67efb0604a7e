// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/height_slabs.h>
#include <traverse/layers/tile_grid.h>
#include <traverse/poses/pose_track.h>
#include <traverse/traversability_grid/params.h>

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace traverse::traversability_grid
{
struct State;
struct Cell;

/** What a map that forgets keeps besides its cells' sums.
 *
 * Sums cannot be taken apart again. So a cell has two: those that everybody reads, and younger ones
 * that were begun later. When the younger ones have half the age or half the points that are
 * allowed they take the place of the others, and new ones are begun: what is read is always of the
 * last half to whole of forget_after_s and forget_after_points. */
struct Memory
{
  struct Young
  {
    int32_t slabs = layers::HeightSlabs::kNone;
    poses::TimeNs since = 0;
    bool is_begun = false;
  };

  using Tile = std::pair<int32_t, int32_t>;  //!< row and column of its smallest cell

  layers::TileGrid<Young> young;
  std::map<Tile, poses::TimeNs> due;               //!< when a tile is to be looked through
  std::set<std::tuple<poses::TimeNs, Tile>> next;  //!< the same by time
};

bool forgets(const Params& params);

/** To be called before a cell gets new points: lets go of what is too old or too much. */
void renew(
    State& state, geometry::CellIndex index, Cell& cell, poses::TimeNs now, const Params& params);

/** New points of a cell, for its younger sums too. */
void addYoung(State& state, geometry::CellIndex index, const layers::HeightSlab& points);

/** Lets go of cells that no sensor has seen for forget_after_s (an eighth more at most). Costs by
 * the tiles that are due, an eighth of the age apart. */
void forgetUnseen(State& state, poses::TimeNs now, const Params& params);

/** The tiles of the scan's cells are to be looked through when they are old enough. */
void watchTiles(State& state, poses::TimeNs now, const Params& params);

/** Lets go of the younger sums in rectangles, and of the tiles wholly outside `kept`. */
void clearYoung(
    State& state, std::span<const geometry::CellRect> gone, const geometry::CellRect& kept);
}  // namespace traverse::traversability_grid
