// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/scan_cells.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;
using ::testing::ElementsAre;

constexpr uint32_t kNone = ScanCells::kNone;
const geometry::Vehicle kCar;

void add(LatticePoints& points, int32_t column, int32_t row, int32_t level, int32_t mm = 1)
{
  const size_t i = points.size++;
  points.column[i] = column;
  points.row[i] = row;
  points.level[i] = level;
  points.x_mm[i] = points.y_mm[i] = points.z_mm[i] = mm;
}

std::vector<uint32_t> numbers(const ScanCells& cells)
{
  return {cells.ofPoints().begin(), cells.ofPoints().end()};
}

/** The cell's slabs, those of one level added up. */
std::map<int32_t, layers::HeightSlab> slabs(const ScanCells& cells, uint32_t number)
{
  std::map<int32_t, layers::HeightSlab> all;
  cells.forEachSlab(number, [&](const ScanSlab& s) { all[s.level].add(s.sums(0)); });
  return all;
}

TEST(ScanCells, NumbersCellsAsTheScanMeetsThemAndKnowsEachPointsCell)
{
  ScanCells cells;
  cells.begin({{-5, 70}, {60, 130}}, {100, 100}, 5);
  LatticePoints points;
  add(points, 3, 4, 0);
  add(points, 64, 59, 1);
  add(points, -1, 0, 0);
  add(points, 3, 4, 7);
  add(points, 0, 0, 0);
  cells.add(points);
  EXPECT_THAT(numbers(cells), ElementsAre(0, 1, kNone, 0, 2));
  EXPECT_EQ(cells.cell(0), (geometry::CellIndex{-2, 74}));
  EXPECT_EQ(cells.cell(1), (geometry::CellIndex{59, 129}));
  EXPECT_EQ(cells.numberOf({-2, 74}), 0U);
  EXPECT_EQ(cells.numberOf({-5, 70}), 2U);
  EXPECT_EQ(cells.numberOf({-4, 70}), kNone);
  for (const int32_t far : {-1'000'000, -6, 60, 1'000'000})
  {
    EXPECT_EQ(cells.numberOf({far, 74}), kNone) << far;
    EXPECT_EQ(cells.numberOf({-2, far}), kNone) << far;
  }
}

TEST(ScanCells, AddsUpByLevelAndBeyondWhatOneSlabHolds)
{
  ScanCells cells;
  cells.begin({{0, 0}, {10, 10}}, {3, 100}, 60);
  LatticePoints points;
  layers::HeightSlab expected;
  for (int32_t i = 0; i < 60; ++i)
  {
    add(points, 1, 1, i % 3, i);
    if (i % 3 == 2)
    {
      const auto mm = static_cast<uint16_t>(i);
      expected.add({mm, mm, mm}, 0);
    }
  }
  cells.add(points);
  ASSERT_EQ(cells.size(), 1U);
  const auto all = slabs(cells, 0);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all.at(2).n, 20U);
  EXPECT_EQ(all.at(2).zz, expected.zz);
  EXPECT_EQ(all.at(2).min_z_mm, 2);
  EXPECT_EQ(all.at(2).max_z_mm, 59);
}

TEST(ScanCells, SumsOfTheWidestCellsNeverOverflow)
{
  for (const auto& [cell_mm, slab_mm] : {std::pair{10'000, 20}, {10, 5'000}, {10'000, 5'000}})
  {
    const uint32_t most = ScanSlab::mostPoints(cell_mm, slab_mm);
    const uint64_t side = static_cast<uint64_t>(std::max(cell_mm, slab_mm));
    EXPECT_GE(most, 1U);
    EXPECT_LT(most * side * side, uint64_t{1} << 32U);
  }
}

TEST(ScanCells, BeginsAgainWithoutATraceOfTheScanBefore)
{
  ScanCells cells;
  LatticePoints points;
  add(points, 3, 4, 0);
  add(points, 40, 40, 0);
  cells.begin({{0, 0}, {50, 50}}, {100, 100}, 2);
  cells.add(points);
  for (const int32_t edge : {10'000, 0, 20, 50})
  {
    cells.begin({{0, 0}, {edge, edge}}, {100, 100}, 2);
    EXPECT_TRUE(cells.empty());
    EXPECT_EQ(cells.ofPoints().size(), 0U);
    EXPECT_EQ(cells.numberOf({3, 4}), kNone);
    EXPECT_EQ(cells.numberOf({40, 40}), kNone);
  }
}

TEST(ScanCells, RefusesPointsThatNeedATileTooMany)
{
  ScanCells cells;
  cells.begin({{0, 0}, {100, 100}}, {100, 1}, 3);
  LatticePoints points;
  add(points, 31, 31, 0);
  add(points, 32, 31, 0);
  add(points, 0, 0, 0);
  cells.add(points);
  EXPECT_THAT(numbers(cells), ElementsAre(0, kNone, 1));
  EXPECT_EQ(cells.refused(), 1U);
}

TEST(ScanCells, RemovedCellsLeaveTheOthersInOrder)
{
  ScanCells cells;
  cells.begin({{0, 0}, {100, 100}}, {100, 100}, 4);
  LatticePoints points;
  add(points, 1, 0, 0);
  add(points, 2, 0, 0);
  add(points, 3, 0, 0);
  add(points, 2, 0, 5);
  cells.add(points);
  cells.remove({true, false, false});
  EXPECT_THAT(numbers(cells), ElementsAre(kNone, 0, 1, 0));
  EXPECT_EQ(cells.numberOf({1, 0}), kNone);
  EXPECT_EQ(cells.numberOf({3, 0}), 1U);
  EXPECT_EQ(slabs(cells, 0).size(), 2U);
}

/** What the state offers about the last scan: cells, where they are stored, and each point's. */
void expectConsistent(const State& state, const points::ScanBuffer& scan)
{
  ASSERT_EQ(state.scan.size(), state.touched.size());
  for (uint32_t i = 0; i < state.scan.size(); ++i)
  {
    ASSERT_EQ(state.cells.indexOf(state.touched[i]), state.scan.cell(i));
    ASSERT_EQ(state.scan.numberOf(state.scan.cell(i)), i);
  }
  ASSERT_EQ(state.scan.ofPoints().size(), scan.size());
  std::vector<bool> has_point(state.scan.size(), false);
  for (size_t i = 0; i < scan.size(); ++i)
  {
    if (const uint32_t number = state.scan.ofPoints()[i]; number != kNone)
    {
      has_point[number] = true;
      EXPECT_NEAR(state.lattice.centre_m(state.scan.cell(number).x), scan.x[i], 0.1011)
          << "half a cell, half a millimetre, a float's resolution";
    }
  }
  EXPECT_THAT(has_point, ::testing::Each(true));
}

TEST(ScanCells, AgreeWithTheMapAfterAnUpdate)
{
  std::mt19937 random(2);
  Params params;
  params.extent = Extent::growing;
  State state = makeState(params, kCar);
  for (int i = 0; i < 3; ++i)
  {
    const points::ScanBuffer scan = randomScan(random, 2'000);
    update(state, scan.view(), atPlace(0, 0), params, kCar);
    expectConsistent(state, scan);
    const State copy = state;
    expectConsistent(copy, scan);
  }
}

TEST(ScanCells, AgreeWithTheMapWhereTheMemoryBudgetIsSpent)
{
  std::mt19937 random(3);
  Params params;
  params.extent = Extent::growing;
  params.max_memory_mb = 1;
  State state = makeState(params, kCar);
  uint64_t refused = 0;
  for (int i = 0; i < 5; ++i)
  {
    const points::ScanBuffer scan = randomScan(random, 5'000, 15.0);
    const layers::UpdateStats stats = update(state, scan.view(), atPlace(0, 0), params, kCar);
    EXPECT_EQ(stats.points + stats.over_budget + stats.outside, scan.size());
    refused += stats.over_budget;
    expectConsistent(state, scan);
  }
  EXPECT_GT(refused, 1'000U);
}

TEST(ScanCells, AreNoneAfterAScanOfNoUse)
{
  std::mt19937 random(4);
  const Params params;
  State state = makeState(params, kCar);
  update(state, randomScan(random, 100).view(), atPlace(0, 0), params, kCar);
  points::ScanBuffer far;
  addPoint(far, 500, 0, 0);
  update(state, far.view(), atPlace(0, 0), params, kCar);
  EXPECT_EQ(state.scan.size(), 0U);
  EXPECT_EQ(state.touched.size(), 0U);
  EXPECT_THAT(numbers(state.scan), ElementsAre(kNone));
}
}  // namespace
