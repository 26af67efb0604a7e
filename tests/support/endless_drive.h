// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/traversability_grid/traversability_grid.h>

#include <algorithm>
#include <limits>
#include <support/endless_street.h>
#include <support/resources.h>
#include <vector>

namespace traverse::testing
{
using namespace traverse::traversability_grid;

inline geometry::Vehicle van()
{
  geometry::Vehicle vehicle;
  vehicle.height_m = 2.2;
  return vehicle;
}

inline const geometry::Vehicle kVan = van();

inline Params with(Extent extent)
{
  Params params;
  params.extent = extent;
  return params;
}

/** The most that a map had of each. */
struct Size
{
  size_t cells = 0;
  size_t tiles = 0;
  size_t slabs = 0;
  size_t driven = 0;
  size_t watched = 0;  //!< tiles that are to be looked through for what is too old

  void raise(const State& state)
  {
    cells = std::max(cells, state.occupied);
    tiles = std::max(tiles, state.cells.tiles());
    slabs = std::max(slabs, state.slabs.size());
    driven = std::max(driven, state.driven.cells().size());
    watched = std::max(watched, state.memory.due.size());
  }
};

/** A map that is driven along the street, and what its updates cost. */
class Drive
{
 public:
  Drive(const Params& params, double length_m, double step_m) :
      params_(params),
      street_(step_m),
      poses_(street_.drive(length_m)),
      state_(makeState(params_, kVan))
  {
    cpu_ms_.reserve(poses_.size());
    windows_.reserve(poses_.size());
  }

  /** Up to that part of the drive. */
  Size go(double share)
  {
    Size most;
    for (size_t i = windows_.size(); i < cloudAt(share); ++i)
    {
      cpu_ms_.push_back(add(state_, i));
      windows_.push_back(state_.window.value_or(geometry::CellRect{}));
      most.raise(state_);
    }
    return most;
  }

  /** The rest of the drive, beside a map that begins here: the same clouds, in turns, so that
   * whatever else the machine does meets both. What a cloud takes, as a multiple of what the young
   * map takes, by medians of the second half, when the young one's window is full. */
  double ageing()
  {
    State young = makeState(params_, kVan);
    std::vector<double> young_ms;
    std::vector<double> old_ms;
    const size_t begin = windows_.size();
    for (size_t i = begin; i < poses_.size(); ++i)
    {
      const bool is_first = i % 2 == 0;
      const double before = is_first ? 0 : add(young, i);
      old_ms.push_back(add(state_, i));
      young_ms.push_back(is_first ? add(young, i) : before);
      windows_.push_back(state_.window.value_or(geometry::CellRect{}));
    }
    return median(old_ms, 0.5, 1) / median(young_ms, 0.5, 1);
  }

  /** Median time of a cloud in a part of what go() drove. */
  double cpuMs(double from, double to) const { return median(cpu_ms_, from, to); }

  /** The first cloud after all of the last window had been out of the map: of what came before, no
   * point is left. */
  size_t firstThatCounts() const
  {
    size_t first = windows_.size();
    while (first > 0 && !geometry::intersection(windows_[first - 1], windows_.back()).empty())
    {
      --first;
    }
    return first;
  }

  /** Clouds before that one which had seen some of the last window already. */
  size_t earlierVisits() const
  {
    const auto end = windows_.begin() + static_cast<std::ptrdiff_t>(firstThatCounts());
    return static_cast<size_t>(std::count_if(
        windows_.begin(), end,
        [&](const geometry::CellRect& w)
        { return !geometry::intersection(w, windows_.back()).empty(); }));
  }

  /** A map of the clouds from that one on. */
  State fresh(size_t first)
  {
    State state = makeState(params_, kVan);
    for (size_t i = first; i < poses_.size(); ++i)
    {
      add(state, i);
    }
    return state;
  }

  size_t clouds() const { return poses_.size(); }

  const State& state() const { return state_; }

  const Params& params() const { return params_; }

  size_t leastPoints() const { return least_points_; }

  double farthest_m() const { return poses_.back().translation().cwiseAbs().maxCoeff(); }

 private:
  size_t cloudAt(double share) const
  {
    return static_cast<size_t>(share * static_cast<double>(poses_.size()));
  }

  /** Milliseconds of the processor. */
  double add(State& state, size_t i)
  {
    const points::Scan scan = street_.cloud(i, poses_[i]).view();
    const double start = cpuSeconds();
    const layers::UpdateStats stats = update(state, scan, poses_[i], params_, kVan);
    const double end = cpuSeconds();
    least_points_ = std::min<size_t>(least_points_, stats.points);
    return 1e3 * (end - start);
  }

  static double median(std::vector<double> all, double from, double to)
  {
    const auto at = [&](double share)
    { return static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size())); };
    const auto middle = all.begin() + (at(from) + at(to)) / 2;
    std::nth_element(all.begin() + at(from), middle, all.begin() + at(to));
    return *middle;
  }

  Params params_;
  EndlessStreet street_;
  std::vector<Eigen::Isometry3d> poses_;
  State state_;
  std::vector<double> cpu_ms_;
  std::vector<geometry::CellRect> windows_;
  size_t least_points_ = std::numeric_limits<size_t>::max();
};

}  // namespace traverse::testing
