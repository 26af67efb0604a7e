// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/layers/height_slabs.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/layers/tile_grid.h>
#include <traverse/traversability_grid/driven.h>
#include <traverse/traversability_grid/forgetting.h>
#include <traverse/traversability_grid/judge.h>
#include <traverse/traversability_grid/params.h>
#include <traverse/traversability_grid/scan_cells.h>
#include <traverse/traversability_grid/scan_source.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace traverse::traversability_grid
{
/** One cell: its sums, and what the last classification made of them. */
struct Cell
{
  int32_t slabs = layers::HeightSlabs::kNone;
  Class of = Class::undefined;
  uint8_t index = kNoIndex;
  float ground_m = std::numeric_limits<float>::quiet_NaN();  //!< map frame; NaN: not known
};

using Cells = layers::TileGrid<Cell>;

/** All that a class depends on besides the cell's sums. */
struct ClassRule
{
  Params params;  //!< only what classes depend on; the rest is left at its defaults
  int64_t clearance_mm = 0;
  double max_step_m = 0;
  double max_slope_deg = 0;

  friend bool operator==(const ClassRule&, const ClassRule&) = default;
};

ClassRule classRule(const Params& params, const geometry::Vehicle& vehicle);

/** The map as a value: copied, compared by its archive, thrown away whole. */
struct State
{
  geometry::Lattice lattice;
  int32_t slab_mm = 500;
  Cells cells;
  layers::HeightSlabs slabs;
  size_t occupied = 0;                       //!< cells with a point
  Memory memory;                             //!< of a map that forgets
  std::optional<geometry::CellRect> window;  //!< the cells kept, where they follow the robot
  std::optional<poses::StampedPose> robot;   //!< latest pose that a scan came with
  DrivenCells driven;                        //!< where the ground is known by the vehicle
  std::vector<std::string> sensors;          //!< labels; HeightSlab::seen_by counts them from bit 0
  ClassRule rule;                            //!< what the cells' classes were made with

  // The last scan's; work space of update(), kept for its capacity.
  ScanCells scan;                     //!< the cells that it touched, numbered; its points' cells
  std::vector<Cells::Place> touched;  //!< by number, where those cells are stored
  Judge judge;                        //!< and what they were judged to be

  bool empty() const { return occupied == 0; }
};

/** How a map with these options divides space. */
struct Division
{
  geometry::Lattice lattice;
  int32_t slab_mm = 0;

  friend bool operator==(const Division&, const Division&) = default;
};

/** Throws OptionError for Params or Vehicle that check() refuses. */
Division divisionOf(const Params& params, const geometry::Vehicle& vehicle);

/** An empty map. Throws as divisionOf() does. */
State makeState(const Params& params, const geometry::Vehicle& vehicle);

/** Step 3's second half: adds the sums of the last scan's cells to the map and notes where they
 * are. What the memory budget has no room for is counted, and its cells leave the scan's. */
void addToMap(
    State& state, const ScanSource& source, const Params& params, layers::UpdateStats& stats);

/** Forgets a cell's points. */
void clearCell(State& state, Cell& cell);

/** The bit of a sensor's label, which is kept from now on; the last bit stands for all labels
 * beyond the 31st. */
uint32_t sensorBit(State& state, std::string_view label);

/** Calls f(number, const Cell&) for the cells at these places, in order, while the next ones are on
 * their way from memory. */
template <class AnyState, class F>
void forEachAt(AnyState& state, std::span<const Cells::Place> places, F&& f)
{
  constexpr size_t kAhead = 8;
  for (size_t i = 0; i < places.size(); ++i)
  {
    if (i + 2 * kAhead < places.size())
    {
      __builtin_prefetch(&state.cells.at(places[i + 2 * kAhead]), 1);
      state.slabs.prefetch(state.cells.at(places[i + kAhead]).slabs);
    }
    f(static_cast<uint32_t>(i), state.cells.at(places[i]));
  }
}

/** The same for the cells of the last scan, which f may change. */
template <class F>
void forEachTouched(State& state, F&& f)
{
  forEachAt(state, state.touched, std::forward<F>(f));
}

/** Calls f(Place, const Cell&) for the cells of a rectangle that have points, in the grid's order.
 */
template <class F>
void forEachOccupiedIn(const State& state, const geometry::CellRect& window, F&& f)
{
  state.cells.forEachIn(
      window,
      [&](Cells::Place place)
      {
        const Cell& cell = state.cells.at(place);
        if (cell.slabs != layers::HeightSlabs::kNone)
        {
          f(place, cell);
        }
      });
}

/** The same for all cells. */
template <class F>
void forEachOccupied(const State& state, F&& f)
{
  state.cells.forEach(
      [&](Cells::Place place)
      {
        const Cell& cell = state.cells.at(place);
        if (cell.slabs != layers::HeightSlabs::kNone)
        {
          f(place, cell);
        }
      });
}

/** Most tiles that a map with these options may have; the slabs have three quarters of the
 * budget. */
size_t mostTiles(const Params& params);
size_t mostSlabs(const Params& params);

/** How features are to be read from this state's slabs. */
SlabReading slabReading(const State& state, const Params& params, const geometry::Vehicle& vehicle);

/** The cells of extent = fixed. */
geometry::CellRect fixedRect(const geometry::Lattice& lattice, const Params& params);

/** Forgets all cells; costs by the cells there. */
void clearCells(State& state);

/** Moves the kept window: cells that leave it are forgotten. Costs by what leaves. */
void moveWindow(State& state, const geometry::CellRect& window);

/** Steps 4 and 5 for the cells at these places, which lie in `window`: features, and classes by
 * themselves and against the ground among them. `judge` has the judgements, in their order. */
void judgeCells(
    const State& state,
    std::span<const Cells::Place> places,
    const geometry::CellRect& window,
    const Params& params,
    const geometry::Vehicle& vehicle,
    Judge& judge);

/** A square of a large map that is judged by itself, with a margin to let the ground in. */
struct Block
{
  geometry::CellRect shown;
  geometry::CellRect judged;
};

/** The blocks of a rectangle that have cells: of 1024 patches, so that a map of any size takes no
 * more memory to judge. */
std::vector<Block> blocksOf(
    const State& state, const Params& params, const geometry::CellRect& window);

/** Judges all cells of a rectangle against the ground that spreads from the driven cells in it, and
 * calls f(Place, const Judgement&) for each that has points: block by block, in the grid's order.
 */
template <class F>
void judgeAll(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    const geometry::CellRect& window,
    F&& f)
{
  Judge judge;
  std::vector<Cells::Place> places;
  for (const Block& block : blocksOf(state, params, window))
  {
    places.clear();
    forEachOccupiedIn(
        state, block.judged,
        [&](Cells::Place place, const Cell& /*cell*/) { places.push_back(place); });
    judgeCells(state, places, block.judged, params, vehicle, judge);
    for (size_t i = 0; i < places.size(); ++i)
    {
      if (block.shown.contains(state.cells.indexOf(places[i])))
      {
        f(places[i], judge.judgements()[i]);
      }
    }
  }
}

void setClass(Cell& cell, const Judgement& judgement, const Params& params);

/** The smallest rectangle with all occupied cells; empty where there is none. */
geometry::CellRect occupiedRect(const State& state);

/** Makes the classes of all cells new. */
void reclassify(State& state, const Params& params, const geometry::Vehicle& vehicle);
}  // namespace traverse::traversability_grid
