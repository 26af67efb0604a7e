// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What hangs over the ground in ini/scenes/overhangs.ini, for two vehicles: under what they fit,
// under what not.
#include <gtest/gtest.h>

#include <memory>
#include <support/paper_5_maps.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using layers::OccupancyState;

/** A place in a thing's middle, and whether the vehicle of 2 m and that of 1.2 m fit below it. A
 * thing that is in the way has obstacles all along y, or all along x. */
struct Row
{
  const char* name;
  Eigen::Vector2d min_m;
  Eigen::Vector2d max_m;
  bool along_y;
  bool fits_high;
  bool fits_low;
};

const std::vector<Row> kTable = {
    {"bridge", {-9.6, -3}, {-6.4, 3}, true, true, true},
    {"tunnel", {25, -3}, {39, 3}, true, true, true},
    {"garage", {-19.4, -10.4}, {-17.4, -6.4}, true, true, true},
    {"garage door's frame, 1.6 m", {-23, 8.6}, {-21, 9.4}, false, false, true},
    {"height bar, 2.3 m", {15.6, -3}, {16.4, 3}, true, true, true},
    {"branch, 2.6 m", {7.6, 0.6}, {8.4, 3.4}, true, true, true},
    {"branch, 1.4 m", {-0.4, 7.6}, {0.4, 8.4}, true, false, true},
    {"table, 0.75 m", {-2.6, -5.4}, {-1.4, -4.6}, false, false, false},
    {"boom, 0.9 m", {19.6, 5.6}, {20.4, 9}, true, false, false},
    {"raised boom, 1.5 m", {13.6, -8.8}, {14.4, -5.2}, true, false, true}};

/** The map at the end of a drive past all of it. */
class OverhangTable : public ::testing::TestWithParam<double>
{
 protected:
  static std::unique_ptr<multi_lidar_grid::State> mapFor(double height_m)
  {
    const config::IniDocument ini = Paper5Drive::ini("overhangs");
    simulation::RecordingParams recording = simulating::readRecording(ini);
    recording.vehicle.height_m = height_m;
    recording.drive.speed_mps = 16;
    recording.drive.accel_mps2 = 0;
    Paper5Drive drive(simulating::readScene(ini), recording, 1);
    multi_lidar_grid::Params params = paper5Params(false);
    params.window_m = 200;  // all of the scene at the end
    auto state = std::make_unique<multi_lidar_grid::State>(params, drive.vehicle());
    while (const auto turn = drive.next())
    {
      points::Decoded cloud = decodeTurn(*turn);
      if (points::deskew(cloud.scan, drive.ins()) != points::Deskew::no_poses)
      {
        multi_lidar_grid::update(*state, cloud.view(), drive.ins(), params, drive.vehicle());
      }
    }
    return state;
  }
};

/** How many cells of a place are free below, how many are obstacles, how many there are; and in how
 * many of the lines across it there is an obstacle. */
struct Seen
{
  int cells = 0;
  int passable = 0;
  int obstacles = 0;
  int lines = 0;
  int blocked_lines = 0;
};

Seen look(const multi_lidar_grid::State& state, const Row& row)
{
  const auto cell = [&](const Eigen::Vector2d& p)
  { return state.lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y())); };
  const geometry::CellIndex min = cell(row.min_m);
  const geometry::CellIndex max = cell(row.max_m);
  std::map<int32_t, bool> lines;
  Seen seen;
  for (geometry::CellIndex c = min; c.y < max.y; ++c.y)
  {
    for (c.x = min.x; c.x < max.x; ++c.x)
    {
      const OccupancyState is = state.cells.get(c)->state;
      ++seen.cells;
      seen.passable += is == OccupancyState::free || is == OccupancyState::overhang ? 1 : 0;
      seen.obstacles += is == OccupancyState::obstacle ? 1 : 0;
      bool& blocked = lines[row.along_y ? c.y : c.x];
      blocked = blocked || is == OccupancyState::obstacle;
    }
  }
  seen.lines = static_cast<int>(lines.size());
  for (const auto& [at, blocked] : lines)
  {
    seen.blocked_lines += blocked ? 1 : 0;
  }
  return seen;
}

TEST_P(OverhangTable, IsRight)
{
  const double height_m = GetParam();
  const auto state = mapFor(height_m);
  for (const Row& row : kTable)
  {
    const Seen seen = look(*state, row);
    if (height_m > 1.5 ? row.fits_high : row.fits_low)
    {
      EXPECT_EQ(seen.obstacles, 0) << row.name;
      // not all of a garage's floor or of what a bush's trunk hides is ever seen
      EXPECT_GE(seen.passable, 0.8 * seen.cells) << row.name;
    }
    else
    {
      // beams at 10 Hz and 16 m/s meet a bar or a branch of loose leaves not in every cell
      EXPECT_GE(seen.blocked_lines, 0.75 * seen.lines) << row.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    TwoVehicles,
    OverhangTable,
    ::testing::Values(2.0, 1.2),
    [](const auto& info) { return info.param > 1.5 ? "high" : "low"; });
}  // namespace
