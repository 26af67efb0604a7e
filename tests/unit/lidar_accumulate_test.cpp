// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/accumulate.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace traverse::multi_lidar_grid;
using traverse::layers::OccupancyState;
using traverse::poses::TimeNs;

constexpr TimeNs kSecond = 1'000'000'000;
constexpr TimeNs kSweep = kSecond / 10;
constexpr uint32_t kRoof = 1;
constexpr uint32_t kWing = 2;

Look look(OccupancyState state, TimeNs stamp, uint32_t sensor = kRoof)
{
  UnitCell cell;
  cell.state = state;
  return {cell, stamp, sensor};
}

/** Looks of one sensor, 'O' obstacle, '.' free, '?' unknown, a sweep apart; the states they left.
 */
std::string after(const std::string& looks, const Params& params = {})
{
  const Accumulator accumulator(params);
  Cell cell;
  std::string states;
  TimeNs stamp = kSecond;
  for (const char what : looks)
  {
    if (what != '?')
    {
      accumulator.add(
          cell, look(what == 'O' ? OccupancyState::obstacle : OccupancyState::free, stamp));
    }
    states += cell.state == OccupancyState::obstacle ? 'O'
              : cell.state == OccupancyState::free   ? '.'
                                                     : '?';
    stamp += kSweep;
  }
  return states;
}
}  // namespace

TEST(LidarAccumulate, AHitIsAnObstacleAtOnceAndThreePassesFreeIt)
{
  EXPECT_EQ(after("?.O...."), "?.OOO..");
  EXPECT_EQ(after("OOOO....."), "OOOOOO...");
}

TEST(LidarAccumulate, UnknownErasesNothing)
{
  EXPECT_EQ(after("O????.??.?."), "OOOOOOOOOO.");
}

TEST(LidarAccumulate, AFenceHitByEveryFifthLookStays)
{
  std::string looks = "O";
  for (int i = 0; i < 40; ++i)
  {
    looks += "....O";
  }
  const std::string states = after(looks);
  // It begins as something that every look hits; what that memory says is gone after 3 s.
  EXPECT_EQ(states.substr(30).find_first_not_of('O'), std::string::npos) << states;
}

TEST(LidarAccumulate, APersonIsGoneWithinASecondHoweverLongTheyStood)
{
  const std::string states = after(std::string(300, 'O') + std::string(10, '.'));
  EXPECT_EQ(states.back(), '.');
}

TEST(LidarAccumulate, WhatOneSensorSeesAndAnotherOverlooksStays)
{
  const Accumulator accumulator{Params{}};
  Cell cell;
  for (int i = 0; i < 100; ++i)
  {
    const TimeNs stamp = kSecond + i * kSweep / 4;  // the roof: 40 sweeps a second
    accumulator.add(cell, look(OccupancyState::free, stamp, kRoof));
    if (i % 8 == 0)  // the wing: 5 a second
    {
      accumulator.add(cell, look(OccupancyState::obstacle, stamp + 1, kWing));
    }
    EXPECT_EQ(cell.state, OccupancyState::obstacle) << i;
  }
  EXPECT_EQ(cell.seen_by, kWing);
}

TEST(LidarAccumulate, WhenTheOneThatSawItIsDeadTheOthersClearIt)
{
  const Accumulator accumulator{Params{}};
  Cell cell;
  accumulator.add(cell, look(OccupancyState::obstacle, kSecond, kWing));
  TimeNs stamp = kSecond;
  while (cell.state == OccupancyState::obstacle && stamp < 3 * kSecond)
  {
    stamp += kSweep;
    accumulator.add(cell, look(OccupancyState::free, stamp, kRoof));
  }
  EXPECT_EQ(stamp, kSecond + 5 * kSweep) << "two within a quarter of a second do not count";
}

TEST(LidarAccumulate, PassesOlderThanTheHitSayNothing)
{
  const Accumulator accumulator{Params{}};
  Cell cell;
  accumulator.add(cell, look(OccupancyState::obstacle, kSecond));
  for (int i = 0; i < 10; ++i)
  {
    accumulator.add(cell, look(OccupancyState::free, kSecond - kSweep));
  }
  EXPECT_EQ(cell.state, OccupancyState::obstacle);
  EXPECT_EQ(cell.last_seen, kSecond);
}

TEST(LidarAccumulate, ADitchBlocksAndIsClearedAsAnObstacleIs)
{
  const Accumulator accumulator{Params{}};
  Cell cell;
  accumulator.add(cell, look(OccupancyState::negative, kSecond));
  EXPECT_EQ(cell.state, OccupancyState::negative);
  accumulator.add(cell, look(OccupancyState::obstacle, kSecond + kSweep));
  accumulator.add(cell, look(OccupancyState::negative, kSecond + 2 * kSweep));
  EXPECT_EQ(cell.state, OccupancyState::obstacle) << "the stronger word counts";
  for (int i = 3; i < 7; ++i)
  {
    accumulator.add(cell, look(OccupancyState::free, kSecond + i * kSweep));
  }
  EXPECT_EQ(cell.state, OccupancyState::free);
}

TEST(LidarAccumulate, ADitchStaysLongerThanBeamsSkimOverIt)
{
  const Accumulator accumulator{Params{}};
  Cell cell;
  accumulator.add(cell, look(OccupancyState::negative, kSecond));
  Look skims = look(OccupancyState::free, 2 * kSecond);
  for (int i = 0; i < 5; ++i)
  {
    accumulator.add(cell, skims);
    skims.stamp += kSweep;
  }
  EXPECT_EQ(cell.state, OccupancyState::negative);
  skims.cell.returns = 1;
  for (int i = 0; i < 3; ++i)
  {
    accumulator.add(cell, skims);
  }
  EXPECT_EQ(cell.state, OccupancyState::free);
}

TEST(LidarAccumulate, LogOddsNeedAsManyPassesAsTheHitsAreWorth)
{
  Params params;
  params.accumulation = Accumulation::log_odds;
  params.log_odds_hit = 0.9;
  params.log_odds_pass = -0.3;
  params.log_odds_most = 1.8;
  EXPECT_EQ(after("O...", params), "OOO.");
  EXPECT_EQ(after("OOOOO......", params), "OOOOOOOOOO.");
  EXPECT_EQ(after("..O", params), "..O") << "0.9 - 0.6 is still above 0";
}

TEST(LidarAccumulate, AUnitMapGoesIntoTheCellsAtItsPlaces)
{
  traverse::layers::WrappedGrid<Cell> cells(50);
  UnitMap map(50);
  cells.moveTo({100'000'000, -7});
  map.cells.moveTo({100'000'010, -7});  // made elsewhere: only what both have counts
  map.stamp = kSecond;
  map.touched = map.cells.region();
  std::mt19937 random(1);
  map.cells.forEach([&](traverse::geometry::CellIndex, UnitCell& cell)
                    { cell.state = static_cast<OccupancyState>(random() % 5); });
  Accumulator(Params{}).add(cells, map, UnitMapper(Params{}, {}), kWing);
  cells.forEach(
      [&](traverse::geometry::CellIndex at, const Cell& cell)
      {
        const UnitCell* said = map.cells.get(at);
        ASSERT_EQ(cell.state, said == nullptr ? OccupancyState::unknown : said->state);
        ASSERT_EQ(cell.seen_by, cell.state == OccupancyState::unknown ? 0 : kWing);
      });
}
