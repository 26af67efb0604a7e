// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "judged_cells.h"

#include <traverse/evaluation/occupancy_score.h>
#include <traverse/layers/occupancy_state.h>

namespace traverse::evaluation
{
namespace
{
using layers::OccupancyState;

/** What a cell is good for, by both codes. */
enum class Kind : uint8_t
{
  unknown,
  free,
  obstacle,
  ditch,
};

Kind kindInMap(uint8_t code)
{
  switch (static_cast<OccupancyState>(code))
  {
    case OccupancyState::free:
    case OccupancyState::overhang:
      return Kind::free;
    case OccupancyState::obstacle:
      return Kind::obstacle;
    case OccupancyState::negative:
      return Kind::ditch;
    default:
      return Kind::unknown;
  }
}

Kind kindInTruth(uint8_t code)
{
  constexpr uint8_t kOccupied = 2;
  constexpr uint8_t kDitch = 4;
  if (code == kOccupied || code == kDitch)
  {
    return code == kOccupied ? Kind::obstacle : Kind::ditch;
  }
  return code == 0 || code > kDitch ? Kind::unknown : Kind::free;
}

/** Map and truth side by side. */
class Comparison
{
 public:
  Comparison(
      const layers::LayerSet& map, const layers::LayerSet& truth, const OccupancyParams& params) :
      params_(params),
      lattice_(truth.lattice),
      map_(viewOf<uint8_t>(map, params.map_layer)),
      truth_(viewOf<uint8_t>(truth, params.truth_layer))
  {
    checkLattice(map, truth);
    if (truth.find(params.returns_layer) != nullptr)
    {
      returns_ = viewOf<uint32_t>(truth, params.returns_layer);
    }
    if (truth.find(params.left_out_layer) != nullptr)
    {
      left_out_ = viewOf<uint8_t>(truth, params.left_out_layer);
    }
  }

  void judge(geometry::CellIndex c, OccupancyScore& score) const
  {
    const double from_centre = squareFromCentre(c);
    const Kind is = inTruth(c);
    if (is == Kind::unknown || from_centre > params_.radius_m * params_.radius_m)
    {
      return;
    }
    if (is == Kind::obstacle && isSeen(c))
    {
      ++score.obstacles;
      score.found_obstacles += isNear(c, Kind::obstacle, &Comparison::inMap) ? 1 : 0;
    }
    if (is == Kind::ditch && from_centre <= params_.ditch_radius_m * params_.ditch_radius_m)
    {
      judgeDitch(c, score);
    }
    if (is == Kind::free)
    {
      ++score.free_cells;
      score.unknown_free += inMap(c) == Kind::unknown ? 1 : 0;
    }
    if (inMap(c) != Kind::unknown && !wasSwept(c))
    {
      judgeKnown(c, score);
    }
  }

 private:
  Kind inMap(geometry::CellIndex c) const { return kindInMap(map_.at(c)); }

  Kind inTruth(geometry::CellIndex c) const { return kindInTruth(truth_.at(c)); }

  double squareFromCentre(geometry::CellIndex c) const
  {
    const double x = lattice_.centre_m(c.x) - params_.centre_x_m;
    const double y = lattice_.centre_m(c.y) - params_.centre_y_m;
    return x * x + y * y;
  }

  /** Without counts of returns, the inside of what came to free cells cannot be told from what was
   * seen. */
  bool isSeen(geometry::CellIndex c) const
  {
    return returns_.size() == 0 ? inMap(c) != Kind::unknown && !wasSwept(c)
                                : returns_.at(c) >= params_.min_returns;
  }

  template <class Test>
  bool anyNear(geometry::CellIndex c, Test&& test) const
  {
    const int32_t reach = params_.tolerance_cells;
    for (int32_t y = c.y - reach; y <= c.y + reach; ++y)
    {
      for (int32_t x = c.x - reach; x <= c.x + reach; ++x)
      {
        if (test(geometry::CellIndex{x, y}))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool isNear(
      geometry::CellIndex c, Kind kind, Kind (Comparison::*of)(geometry::CellIndex) const) const
  {
    return anyNear(c, [&](geometry::CellIndex n) { return (this->*of)(n) == kind; });
  }

  bool wasSwept(geometry::CellIndex c) const
  {
    return left_out_.size() > 0 &&
           anyNear(c, [&](geometry::CellIndex n) { return left_out_.at(n) != 0; });
  }

  void judgeDitch(geometry::CellIndex c, OccupancyScore& score) const
  {
    const bool found = isNear(c, Kind::ditch, &Comparison::inMap);
    ++score.ditches;
    score.found_ditches += found ? 1 : 0;
    score.ditches_as_free += !found && inMap(c) == Kind::free ? 1 : 0;
  }

  /** A cell that the map says something of. */
  void judgeKnown(geometry::CellIndex c, OccupancyScore& score) const
  {
    const Kind says = inMap(c);
    const bool free_in_map = says == Kind::free;
    const bool free_in_truth = inTruth(c) == Kind::free;
    const auto same = [&](geometry::CellIndex n)
    { return inTruth(n) != Kind::unknown && (inTruth(n) == Kind::free) == free_in_map; };
    const bool forgiven = free_in_map != free_in_truth && anyNear(c, same);
    if (free_in_truth)
    {
      ++score.known_free;
      score.false_obstacles += says == Kind::obstacle && !forgiven ? 1 : 0;
      score.false_ditches += says == Kind::ditch && !forgiven ? 1 : 0;
    }
    score.free_in_both += free_in_map && free_in_truth ? 1 : 0;
    score.free_in_either += (free_in_map || free_in_truth) && !forgiven ? 1 : 0;
  }

  const OccupancyParams& params_;
  geometry::Lattice lattice_;
  CellView<uint8_t> map_;
  CellView<uint8_t> truth_;
  CellView<uint32_t> returns_;
  CellView<uint8_t> left_out_;
};
}  // namespace

OccupancyScore& OccupancyScore::operator+=(const OccupancyScore& other)
{
  obstacles += other.obstacles;
  found_obstacles += other.found_obstacles;
  known_free += other.known_free;
  false_obstacles += other.false_obstacles;
  false_ditches += other.false_ditches;
  free_in_both += other.free_in_both;
  free_in_either += other.free_in_either;
  ditches += other.ditches;
  found_ditches += other.found_ditches;
  ditches_as_free += other.ditches_as_free;
  free_cells += other.free_cells;
  unknown_free += other.unknown_free;
  return *this;
}

double OccupancyScore::obstacleRecall() const
{
  return share(found_obstacles, obstacles);
}

double OccupancyScore::falseObstacleRate() const
{
  return share(false_obstacles, known_free);
}

double OccupancyScore::falseDitchRate() const
{
  return share(false_ditches, known_free);
}

double OccupancyScore::freeIou() const
{
  return share(free_in_both, free_in_either);
}

double OccupancyScore::ditchRecall() const
{
  return share(found_ditches, ditches);
}

double OccupancyScore::ditchAsFreeRate() const
{
  return share(ditches_as_free, ditches);
}

double OccupancyScore::blindShare() const
{
  return share(unknown_free, free_cells);
}

OccupancyScore occupancyScore(
    const layers::LayerSet& map, const layers::LayerSet& truth, const OccupancyParams& params)
{
  const Comparison comparison(map, truth, params);
  OccupancyScore score;
  forEachCell(truth.extent, [&](geometry::CellIndex c) { comparison.judge(c, score); });
  return score;
}
}  // namespace traverse::evaluation
