// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/accumulate.h>

#include <algorithm>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
using layers::OccupancyState;

constexpr int kSure = 127;
constexpr int kShareStep = 16;  // a look counts for a 16th of the share, the looks before for less
constexpr int kForgotten = 16;  // a free cell of less is as one that was never hit
constexpr int kSkims = 2;  // so many beams over a ditch say as much as one that met ground there
constexpr int kMostPasses = 250;

bool blocks(OccupancyState state)
{
  return state == OccupancyState::obstacle || state == OccupancyState::negative;
}

int steps(double log_odds)
{
  const long n = std::lround(log_odds / kLogOddsStep);
  return static_cast<int>(std::clamp(n, -127L, 127L));
}

/** A 16th of the way to all or none, rounded up so that it gets there. */
int8_t towards(int share, int goal)
{
  const int left = goal - share;
  const int step = (std::abs(left) + kShareStep - 1) / kShareStep;
  return static_cast<int8_t>(left < 0 ? share - step : share + step);
}

/** The share after the looks in a row that passed: so long it is left as it was, to be held against
 * them. */
int8_t afterPasses(const Cell& cell)
{
  int8_t share = cell.belief;
  for (int i = 0; i < cell.passes && share > 0; ++i)
  {
    share = towards(share, 0);
  }
  return share;
}

void become(Cell& cell, OccupancyState state, uint32_t sensor_bit)
{
  cell.seen_by = cell.state == state ? cell.seen_by | sensor_bit : sensor_bit;
  cell.state = state;
}
}  // namespace

Accumulator::Accumulator(const Params& params) :
    log_odds_(params.accumulation == Accumulation::log_odds),
    clear_after_(params.clear_after_sweeps),
    hit_step_(std::max(1, steps(params.log_odds_hit))),
    pass_step_(std::min(-1, steps(params.log_odds_pass))),
    most_(std::max(1, steps(params.log_odds_most)))
{
}

void Accumulator::hit(Cell& cell, const Look& look) const
{
  const bool is_first = !blocks(cell.state);
  cell.last_hit = std::max(cell.last_hit, look.stamp);
  if (log_odds_)
  {
    cell.belief = static_cast<int8_t>(std::min(cell.belief + hit_step_, most_));
    if (cell.belief <= 0)
    {
      return;
    }
  }
  else
  {
    const int8_t share = is_first ? cell.belief : afterPasses(cell);
    const bool is_new = is_first && share < kForgotten;
    cell.belief = is_new ? int8_t{kSure} : towards(share, kSure);
  }
  cell.passes = 0;
  // What one sensor calls a ditch and another an obstacle is an obstacle.
  const bool stays = cell.state == OccupancyState::obstacle && !is_first;
  cell.up_to = is_first ? look.cell.up_to : std::max(cell.up_to, look.cell.up_to);
  cell.hit_from = is_first ? look.cell.hit_from : std::min(cell.hit_from, look.cell.hit_from);
  become(cell, stays ? OccupancyState::obstacle : look.cell.state, look.sensor_bit);
}

bool Accumulator::isContradicted(const Cell& cell) const
{
  if (log_odds_)
  {
    return cell.belief <= 0;
  }
  const int looks = clear_after_ * kSure / std::max<int>(cell.belief, kSure / 16);
  const int enough = cell.state == OccupancyState::negative ? looks * kSkims : looks;
  return cell.passes >= std::min(enough, kMostPasses);
}

void Accumulator::pass(Cell& cell, const Look& look) const
{
  if (blocks(cell.state))
  {
    const bool is_other = (cell.seen_by & look.sensor_bit) == 0;
    const double since_s = poses::secondsBetween(cell.last_hit, look.stamp);
    if (since_s <= 0 || (is_other && since_s < kOthersWait_s && !log_odds_))
    {
      return;
    }
  }
  if (log_odds_)
  {
    cell.belief = static_cast<int8_t>(std::max(cell.belief + pass_step_, -most_));
  }
  else if (!blocks(cell.state))
  {
    cell.belief = towards(cell.belief, 0);
  }
  const bool is_met = cell.state == OccupancyState::negative && look.cell.returns > 0;
  cell.passes = static_cast<uint8_t>(std::min(cell.passes + (is_met ? kSkims : 1), kMostPasses));
  if (blocks(cell.state))
  {
    if (!isContradicted(cell))
    {
      return;
    }
    cell.belief = log_odds_ ? cell.belief : afterPasses(cell);
    cell.passes = 0;
    cell.hit_from = 0;
  }
  if (look.cell.state == OccupancyState::unknown)
  {
    become(cell, OccupancyState::unknown, 0);
    return;
  }
  const bool hangs = look.cell.state == OccupancyState::overhang;
  const bool hung = cell.state == OccupancyState::overhang;
  cell.up_to = look.cell.up_to;
  become(cell, hangs || hung ? OccupancyState::overhang : OccupancyState::free, look.sensor_bit);
}

void Accumulator::add(Cell& cell, const Look& look) const
{
  if (blocks(look.cell.state))
  {
    hit(cell, look);
  }
  else
  {
    pass(cell, look);
  }
  cell.last_seen = std::max(cell.last_seen, look.stamp);
}

void Accumulator::add(
    layers::WrappedGrid<Cell>& cells,
    const UnitMap& map,
    const UnitMapper& mapper,
    uint32_t sensor_bit) const
{
  // An obstacle's upper edge is where a beam may pass it and its cell.
  constexpr double kUpperEdge_m = 0.1;
  constexpr int kSlack = 2;  // steps, of the ground's height from look to look
  const auto speaks = [&](geometry::CellIndex cell, const UnitCell& look, const Cell& stored)
  {
    if (stored.state != OccupancyState::obstacle || blocks(look.state))
    {
      return look.state != OccupancyState::unknown;
    }
    const bool is_free = look.state != OccupancyState::unknown;
    return (is_free && look.up_to + kSlack >= stored.hit_from) ||
           mapper.passedBetween(
               map, cell, stored.hit_from * kFreeStep_m, stored.up_to * kFreeStep_m - kUpperEdge_m);
  };
  map.cells.forEachRunIn(
      geometry::intersection(cells.region(), map.touched),
      [&](geometry::CellIndex first, std::span<const UnitCell> run)
      {
        Cell* const stored = &cells.at(first);  // both grids wrap at the same columns
        for (size_t i = 0; i < run.size(); ++i)
        {
          const geometry::CellIndex cell = {first.x + static_cast<int32_t>(i), first.y};
          if (speaks(cell, run[i], stored[i]))
          {
            add(stored[i], {run[i], map.stamp, sensor_bit});
          }
        }
      });
}
}  // namespace traverse::multi_lidar_grid
