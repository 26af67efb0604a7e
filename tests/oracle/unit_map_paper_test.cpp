// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/drawn_lidar.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

using traverse::layers::OccupancyState;
using traverse::testing::DrawnLidar;
using traverse::testing::DrawnUnitMap;

namespace traverse
{
namespace
{
DrawnUnitMap paperGrid()
{
  DrawnUnitMap grid;
  grid.params.cells = multi_lidar_grid::CellRule::paper;
  grid.params.trace = multi_lidar_grid::TraceRule::paper;
  grid.vehicle.height_m = 1.6;
  return grid;
}

/** The paper's rule, word by word, heights in mm. */
OccupancyState sorted(std::vector<int> p, int obstacle_mm, int robot_mm)
{
  std::sort(p.begin(), p.end());
  const bool is_positive = p.size() > 1 && p.back() - p.front() > obstacle_mm;
  bool is_overhang = false;
  for (size_t j = 0; j + 1 < p.size(); ++j)
  {
    is_overhang = is_overhang || (p[j + 1] - p[j] > robot_mm && p[j] - p.front() < obstacle_mm);
  }
  if (is_overhang)
  {
    return OccupancyState::overhang;
  }
  return is_positive ? OccupancyState::obstacle : OccupancyState::unknown;
}

TEST(PaperCells, AreThoseOfSortingAllPoints)
{
  std::mt19937 random(5);  // fixed
  std::map<std::pair<int, int>, std::vector<int>> cells;
  points::ScanBuffer scan;
  scan.T_base_sensor.translation() = Eigen::Vector3d(0, 0, 1.9);
  // Steps of 50 mm, so that differences of just the thresholds come often.
  for (int i = 0; i < 20000; ++i)
  {
    const int x = static_cast<int>(random() % 100) - 50;
    const int y = static_cast<int>(random() % 100) - 50;
    const int z_mm = static_cast<int>(random() % 60) * 50 * static_cast<int>(random() % 2);
    cells[{x, y}].push_back(z_mm);
    DrawnLidar::add({x * 0.2 + 0.1, y * 0.2 + 0.1, z_mm / 1000.0}, 0, scan);
  }
  DrawnUnitMap grid = paperGrid();
  grid.make(scan.view());
  std::array<int, 5> count{};
  for (const auto& [cell, heights] : cells)
  {
    const OccupancyState expected = sorted(heights, 250, 1600);
    OccupancyState found = grid.map.cells.at({cell.first, cell.second}).state;
    found = found == OccupancyState::free ? OccupancyState::unknown : found;
    ASSERT_EQ(found, expected) << cell.first << ' ' << cell.second;
    ++count[static_cast<size_t>(expected)];
  }
  EXPECT_GT(count[0], 500);
  EXPECT_GT(count[2], 500);
  EXPECT_GT(count[4], 100);
}

/** Two points in a cell make it an obstacle. */
void stand(int x, int y, points::ScanBuffer& scan)
{
  DrawnLidar::add({x * 0.2 + 0.1, y * 0.2 + 0.1, 0}, 0, scan);
  DrawnLidar::add({x * 0.2 + 0.1, y * 0.2 + 0.1, 1}, 0, scan);
}

TEST(PaperTrace, NoRaySlipsBetweenDiagonalCells)
{
  // A ring of cells that touch at corners only, in pieces, around the lidar's cell.
  points::ScanBuffer scan;
  scan.T_base_sensor.translation() = Eigen::Vector3d(0.1, 0.1, 1.9);
  constexpr int kRadius = 60;
  for (int i = 0; i < kRadius; ++i)
  {
    stand(i, kRadius - i, scan);
    stand(-i, kRadius - i, scan);
    stand(i, i - kRadius, scan);
    stand(-i, i - kRadius, scan);
  }
  stand(kRadius, 0, scan);
  stand(-kRadius, 0, scan);
  DrawnUnitMap grid = paperGrid();
  grid.make(scan.view());
  int outside = 0;
  int inside = 0;
  grid.map.cells.forEach(
      [&](geometry::CellIndex cell, const multi_lidar_grid::UnitCell& value)
      {
        const int distance = std::abs(cell.x) + std::abs(cell.y);
        const bool is_free = value.state == OccupancyState::free;
        outside += distance > kRadius && is_free ? 1 : 0;
        inside += distance < kRadius - 1 && !is_free ? 1 : 0;
      });
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(inside, 0);
}

/** A line of cells, 8-connected, 10 m off, so thin as a line can be drawn. */
points::ScanBuffer wallAcross(const geometry::SinCos& v)
{
  points::ScanBuffer scan;
  scan.T_base_sensor.translation() = Eigen::Vector3d(0.1, 0.1, 1.9);
  const bool is_flat = std::abs(v.sin) > std::abs(v.cos);
  for (int i = -140; i <= 140; ++i)
  {
    const double other = is_flat ? (50 - i * v.cos) / v.sin : (50 - i * v.sin) / v.cos;
    const int j = static_cast<int>(std::lround(other));
    if (std::abs(j) < 145)
    {
      stand(is_flat ? i : j, is_flat ? j : i, scan);
    }
  }
  return scan;
}

TEST(PaperTrace, AWallOfAnyDirectionHidesWhatIsBehind)
{
  for (int step = 0; step < 72; ++step)
  {
    const geometry::SinCos v = geometry::sinCosOf(step * geometry::kPi / 36);
    const points::ScanBuffer scan = wallAcross(v);
    DrawnUnitMap grid = paperGrid();
    grid.make(scan.view());
    int behind = 0;
    for (int far = 60; far < 130; ++far)
    {
      const auto cell = grid.cellAt(v.cos * far * 0.2, v.sin * far * 0.2);
      behind += grid.map.cells.at(cell).state == OccupancyState::free ? 1 : 0;
    }
    EXPECT_EQ(behind, 0) << step * 5;
    EXPECT_EQ(grid.stateAt(v.cos * 8, v.sin * 8), OccupancyState::free) << step * 5;
  }
}

TEST(PaperTrace, CoversTheFieldOfViewWithoutGaps)
{
  points::ScanBuffer scan;
  scan.T_base_sensor.translation() = Eigen::Vector3d(0.1, 0.1, 1.9);
  stand(5, -5, scan);  // out of view
  DrawnUnitMap grid = paperGrid();
  grid.sensor.range_m = 25;
  grid.sensor.first_azimuth_deg = 20;
  grid.sensor.last_azimuth_deg = 250;
  grid.make(scan.view());
  int wrong = 0;
  grid.map.cells.forEach(
      [&](geometry::CellIndex cell, const multi_lidar_grid::UnitCell& value)
      {
        const double deg = geometry::angleOf(cell.y, cell.x) * 180 / geometry::kPi;
        const double from_first = deg < 20 ? deg + 360 - 20 : deg - 20;
        const bool is_at_edge = std::abs(from_first) < 0.01 || std::abs(from_first - 230) < 0.01;
        const bool is_in = from_first <= 230 && cell.x * cell.x + cell.y * cell.y <= 125 * 125;
        const bool is_free = value.state == OccupancyState::free;
        wrong += !is_at_edge && (cell.x != 0 || cell.y != 0) && is_in != is_free ? 1 : 0;
      });
  EXPECT_EQ(wrong, 0);
}
}  // namespace
}  // namespace traverse
