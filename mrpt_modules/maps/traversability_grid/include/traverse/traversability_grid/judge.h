// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/ground/estimator.h>
#include <traverse/traversability_grid/driven.h>
#include <traverse/traversability_grid/features.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace traverse::traversability_grid
{
/** What is known of a cell once the ground is. Heights are of the map frame. */
struct Judgement
{
  Class of = Class::undefined;
  bool overhangs = false;                                    //!< only what the vehicle fits under
  float ground_m = std::numeric_limits<float>::quiet_NaN();  //!< NaN: not known
  float ground_limit_mm = -std::numeric_limits<float>::infinity();  //!< points up to it are ground
  float top_mm = 0;  //!< points above lie beyond a gap that the vehicle fits under
};

/** Steps 5 and 6 for a set of cells: each by itself, then all of them against the ground that
 * spreads among them. Keeps its work space. */
class Judge
{
 public:
  /** The cells to come lie in `window`. */
  void begin(
      const Params& params,
      const geometry::Vehicle& vehicle,
      const geometry::Lattice& lattice,
      const geometry::CellRect& window,
      const DrivenCells& driven);

  void add(geometry::CellIndex cell, const Features& features);

  /** The features of the i-th cell that was added, read from a height upward. */
  using Reread = std::function<Features(size_t i, int64_t floor_mm)>;

  /** Judges the cells against the ground. Where a return from far under the ground was taken for a
   * cell's lowest surface the cell is read again, from the ground upward. */
  void finish(const Reread& reread);

  /** One judgement per cell that was added, in that order; until the next begin(). */
  std::span<const Judgement> judgements() const { return judgements_; }

 private:
  ground::Column columnOf(geometry::CellIndex cell, const Features& f) const;
  Judgement byItself(const Features& f) const;
  ground::Verdict secondLook(size_t i, const ground::Verdict& first, const Reread& reread);
  Class withRelief(Class of, const ground::Verdict& verdict) const;
  void againstGround(
      const ground::Column& column, const ground::Verdict& verdict, Judgement& judgement) const;

  Params params_;
  std::optional<Classifier> classify_;
  ground::Params ground_params_;
  double clearance_m_ = 0;
  geometry::Lattice lattice_;
  geometry::CellRect window_;
  int64_t reference_mm_ = 0;
  std::vector<ground::Seed> seeds_;
  std::vector<ground::Column> columns_;
  std::vector<Judgement> judgements_;
  ground::Estimator estimator_;
};

/** A surface so far below the ground around it may be a false return; what lies up to kFloor_m
 * below the ground is then the first to count. */
inline constexpr float kFalseReturn_m = 0.5F;
inline constexpr float kFloor_m = 0.3F;
}  // namespace traverse::traversability_grid
