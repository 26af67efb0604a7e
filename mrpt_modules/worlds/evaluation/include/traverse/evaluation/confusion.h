// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::evaluation
{
/** How often a cell of one class was found as another. Class 0 is "undefined": it may be found, and
 * is then wrong, but is no truth. */
class Confusion
{
 public:
  Confusion() = default;

  /** Names by code, [0] undefined. */
  explicit Confusion(std::vector<std::string> names);

  /** Counts one cell. Throws std::out_of_range for a code that has no name, or truth 0. */
  void add(uint8_t truth, uint8_t found);

  /** Adds what was counted elsewhere. Throws std::invalid_argument for other names; a
   * default-constructed one takes the other's. */
  Confusion& operator+=(const Confusion& other);

  uint64_t cells(uint8_t truth, uint8_t found) const;

  uint64_t total() const;

  const std::vector<std::string>& names() const { return names_; }

  /** Cells that were not counted: too few returns, no truth, left out by the caller. */
  uint64_t left_out = 0;

 private:
  size_t at(uint8_t truth, uint8_t found) const;

  std::vector<std::string> names_;
  std::vector<uint64_t> counts_;  // row by row of the truth
};

/** How well one class was found; NaN where nothing can be said: no such cell in truth (recall),
 * none found (precision), neither (f1, iou). */
struct ClassScore
{
  std::string name;
  uint64_t truth_cells = 0;
  uint64_t found_cells = 0;
  uint64_t right_cells = 0;
  double recall = 0;  //!< share of the true cells that were found: the class's accuracy
  double precision = 0;
  double f1 = 0;
  double iou = 0;
};

struct ClassScores
{
  std::vector<ClassScore> classes;  //!< without undefined, by code
  double mean_accuracy = 0;         //!< mean recall of the classes that are there; NaN: none is
  double accuracy = 0;              //!< share of all cells that are right; NaN: no cells
};

ClassScores scoresOf(const Confusion& confusion);

/** Which cells of a map are judged. */
struct ConfusionParams
{
  std::string truth_layer = "truth_class";
  std::string returns_layer = "point_count";   //!< of the map; uint32, or uint8
  uint32_t min_returns = 3;                    //!< cells with fewer are left out
  std::string left_out_layer = "truth_swept";  //!< of the truth, uint8: cells that are not 0 are
                                               //!< left out; none are where there is no such layer
};

/** The map's class layer against the truth, cell by cell where both are. A cell that is undefined
 * in the map although it has returns enough counts as wrong; cells with fewer, and those without a
 * class in truth, are left out. Codes mean the same in both: the truth's legend.
 *
 * Throws std::invalid_argument where the cells are not of the same size or a layer is missing or of
 * another type. */
Confusion confusionOf(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params = {});
}  // namespace traverse::evaluation
