// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/confusion.h>
#include <traverse/layers/layer_set.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace traverse::evaluation
{
/** The code of obstacles, in map and truth. */
inline constexpr uint8_t kObstacle = 4;

/** How many of the obstacles were found, and how many were made up. */
struct ObstacleScore
{
  uint64_t true_cells = 0;       //!< true obstacle cells with returns enough
  uint64_t found_cells = 0;      //!< of them, found as obstacles
  uint64_t objects = 0;          //!< things with such cells (the ground is none)
  uint64_t found_objects = 0;    //!< of them, with one found cell at least
  uint64_t map_cells = 0;        //!< cells found as obstacles, where there is truth
  uint64_t phantom_cells = 0;    //!< of them, farther than one cell from any true obstacle
  std::vector<uint32_t> seen;    //!< numbers of the things, ascending
  std::vector<uint32_t> missed;  //!< of those that were not found

  double cellRecall() const;    //!< NaN without true cells
  double objectRecall() const;  //!< NaN without things
  double phantomShare() const;  //!< of the found cells; NaN where there are none
};

/** Obstacle cells of the map against those of the truth (layers truth_class and truth_object),
 * where returns are enough. Cells left out (ConfusionParams) count nowhere, but true obstacles
 * among them do not make phantoms of their neighbours. Throws std::invalid_argument as
 * confusionOf(). */
ObstacleScore obstacleScore(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params = {});

/** What a map says of a cell. */
enum class FoundState : uint8_t
{
  unknown = 0,
  free = 1,
  occupied = 2,
};

/** States of the map against those of the truth (layer truth_state), all cells of the truth. */
struct StateAgreement
{
  static constexpr size_t kTrueStates = 5;  //!< unknown, free, occupied, overhang, ditch
  static constexpr size_t kFoundStates = 3;

  std::array<std::array<uint64_t, kFoundStates>, kTrueStates> cells{};

  /** Share of the true free (overhang: free below) cells, of those that the map knows, that are
   * free in the map; NaN where it knows none. */
  double freeAgreement() const;

  /** The same for occupied cells and ditches: occupied in the map. */
  double occupiedAgreement() const;

  /** Share of the cells with a true state that the map says something of. */
  double knownShare() const;
};

/** Class 0 is unknown, kObstacle occupied, all others free. Cells of the truth's left_out_layer
 * count nowhere. Throws std::invalid_argument as confusionOf(). */
StateAgreement stateAgreement(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params = {});
}  // namespace traverse::evaluation
