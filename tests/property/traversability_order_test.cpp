// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;

const geometry::Vehicle kCar;

struct Visit
{
  points::ScanBuffer scan;
  Eigen::Isometry3d T_map_base;
};

Params growing()
{
  Params params;
  params.extent = Extent::growing;
  return params;
}

/** A drive with turns and tilts, so that no coordinate falls on a millimetre by itself. */
std::vector<Visit> drive(unsigned seed, int scans)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Visit> visits;
  for (int i = 0; i < scans; ++i)
  {
    Eigen::Isometry3d T = atPlace(1.3 * i, 3 * any(random), 0.4 * any(random), any(random));
    T.rotate(Eigen::AngleAxisd(0.1 * any(random), Eigen::Vector3d::UnitX()));
    visits.push_back({randomScan(random, 800), T});
  }
  return visits;
}

std::string mapOf(const std::vector<Visit>& visits, const Params& params)
{
  State state = makeState(params, kCar);
  for (const Visit& v : visits)
  {
    update(state, v.scan.view(), v.T_map_base, params, kCar);
  }
  return archive(state, params, kCar);
}

TEST(Order, OfScansDoesNotMatter)
{
  std::vector<Visit> visits = drive(1, 20);
  const std::string expected = mapOf(visits, growing());
  EXPECT_GT(expected.size(), 100'000U) << "there is something to compare";
  std::mt19937 random(2);
  for (int round = 0; round < 5; ++round)
  {
    std::shuffle(visits.begin(), visits.end(), random);
    EXPECT_EQ(mapOf(visits, growing()), expected);
  }
}

TEST(Order, OfPointsDoesNotMatter)
{
  std::vector<Visit> visits = drive(3, 3);
  const std::string expected = mapOf(visits, growing());
  std::mt19937 random(4);
  for (Visit& v : visits)
  {
    std::vector<size_t> order(v.scan.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    points::ScanBuffer shuffled;
    shuffled.stamp = v.scan.stamp;
    for (const size_t i : order)
    {
      addPoint(shuffled, v.scan.x[i], v.scan.y[i], v.scan.z[i]);
    }
    v.scan = shuffled;
  }
  EXPECT_EQ(mapOf(visits, growing()), expected);
}

TEST(Order, OfAScansPiecesDoesNotMatter)
{
  std::vector<Visit> whole = drive(5, 4);
  for (Visit& v : whole)
  {
    v.scan.T_base_sensor.translation().z() = 50;  // what is at its height is told scan by scan
  }
  std::vector<Visit> pieces;
  std::mt19937 random(6);
  for (const Visit& v : whole)
  {
    std::vector<Visit> parts(3, Visit{{}, v.T_map_base});
    for (size_t i = 0; i < v.scan.size(); ++i)
    {
      points::ScanBuffer& part = parts[random() % parts.size()].scan;
      part.stamp = v.scan.stamp;
      part.T_base_sensor = v.scan.T_base_sensor;
      addPoint(part, v.scan.x[i], v.scan.y[i], v.scan.z[i]);
    }
    pieces.insert(pieces.begin(), parts.begin(), parts.end());
  }
  EXPECT_EQ(mapOf(pieces, growing()), mapOf(whole, growing()));
}

TEST(Order, OnePointMoreIsAnotherMap)
{
  std::vector<Visit> visits = drive(7, 2);
  const std::string before = mapOf(visits, growing());
  addPoint(visits[0].scan, 0.5, 0.5, 0.1);
  EXPECT_NE(mapOf(visits, growing()), before);
}

/** Sums mirrored in y against sums: the cell at row -1 - j, with y from the other edge. */
void expectMirrored(const layers::LayerSet& left, const layers::LayerSet& right)
{
  const auto width = static_cast<size_t>(left.extent.width());
  const auto height = static_cast<size_t>(left.extent.height());
  for (const char* name : {"traversability_class", "point_count"})
  {
    const auto at = [&](const layers::LayerSet& set, size_t row, size_t column)
    {
      return std::visit(
          [&](const auto& data) { return static_cast<double>(data[row * width + column]); },
          set.find(name)->data);
    };
    for (size_t row = 0; row < height; ++row)
    {
      for (size_t column = 0; column < width; ++column)
      {
        ASSERT_EQ(at(left, row, column), at(right, height - 1 - row, column))
            << name << " at " << row << ", " << column;
      }
    }
  }
}

TEST(Mirror, AMirroredWorldGivesTheMirroredMap)
{
  std::mt19937 random(8);
  points::ScanBuffer scan;
  points::ScanBuffer mirrored;
  // At least a millimetre off the cells' edges, and at whole millimetres: no point changes its cell
  // by being mirrored.
  for (int i = 0; i < 30'000; ++i)
  {
    const auto below = [&](unsigned end) { return static_cast<int>(random() % end); };
    const double x = 0.2 * (below(40) - 20) + 0.001 * (1 + below(198));
    const double y = 0.2 * (below(40) - 20) + 0.001 * (1 + below(198));
    const double z = 0.001 * (below(400) < 380 ? below(25) : below(900));
    addPoint(scan, x, y, z);
    addPoint(mirrored, x, -y, z);
  }
  const geometry::CellRect window{{-20, -20}, {20, 20}};
  const Params params = growing();
  State a = makeState(params, kCar);
  State b = makeState(params, kCar);
  update(a, scan.view(), atPlace(0, 0), params, kCar);
  update(b, mirrored.view(), atPlace(0, 0), params, kCar);
  expectMirrored(layerSet(a, params, kCar, window), layerSet(b, params, kCar, window));
}

/** Every cell's sums as text, to compare maps whatever their extent. */
std::string cellsOf(const State& state)
{
  std::string all;
  state.cells.forEach(
      [&](Cells::Place place)
      {
        const auto index = state.cells.indexOf(place);
        const Cell& cell = state.cells.at(place);
        for (const auto* s = state.slabs.get(cell.slabs); s != nullptr;
             s = state.slabs.get(s->next))
        {
          for (const int64_t number :
               {int64_t{index.x}, int64_t{index.y}, int64_t{s->level}, int64_t{s->n}, s->x, s->y,
                s->z, s->xx, s->xy, s->yy, s->xz, s->yz, s->zz, s->last_seen,
                static_cast<int64_t>(cell.of)})
          {
            all += std::to_string(number) + ' ';
          }
        }
      });
  return all;
}

/** The slow and obvious rolling map: a growing one in which, before each scan, every cell outside
 * the robot's window is emptied by a sweep over all of them. */
class SweptMap
{
 public:
  explicit SweptMap(const Params& params) : params_(params), state_(makeState(params, kCar)) {}

  void add(const Visit& v)
  {
    const geometry::CellIndex robot = state_.lattice.cellOf(
        geometry::toMillimetres(v.T_map_base.translation().x()),
        geometry::toMillimetres(v.T_map_base.translation().y()));
    const auto side = static_cast<int32_t>(std::lround(params_.window_m / params_.cell_size_m));
    const geometry::CellIndex min{robot.x - side / 2, robot.y - side / 2};
    const geometry::CellRect window{min, {min.x + side, min.y + side}};
    state_.cells.forEach(
        [&](Cells::Place place)
        {
          Cell& cell = state_.cells.at(place);
          if (!window.contains(state_.cells.indexOf(place)))
          {
            state_.slabs.release(cell.slabs);
            cell = Cell{};
          }
        });
    state_.driven.keep(window, state_.lattice);
    update(state_, v.scan.view(), v.T_map_base, params_, kCar);
  }

  const State& state() const { return state_; }

 private:
  Params params_;
  State state_;
};

TEST(RollingWindow, IsADenseMapThatForgetsWhatLeavesTheWindow)
{
  Params rolling;
  rolling.window_m = 6.2;
  Params dense = rolling;
  dense.extent = Extent::growing;
  State state = makeState(rolling, kCar);
  SweptMap swept(dense);
  std::vector<Visit> visits = drive(9, 30);
  visits[20].T_map_base.translation().x() += 500;  // a jump beyond the window, and back
  for (const Visit& v : visits)
  {
    update(state, v.scan.view(), v.T_map_base, rolling, kCar);
    swept.add(v);
    ASSERT_EQ(cellsOf(state), cellsOf(swept.state()));
    EXPECT_LE(state.cells.tiles(), 9U) << "tiles that left are given back";
  }
}

/** Cells with points, and their slabs, as found by a sweep. */
std::pair<size_t, size_t> sweptSize(const State& state)
{
  std::pair<size_t, size_t> found;
  state.cells.forEach(
      [&](Cells::Place place)
      {
        const Cell& cell = state.cells.at(place);
        found.first += static_cast<size_t>(cell.slabs != layers::HeightSlabs::kNone);
        for (const auto* s = state.slabs.get(cell.slabs); s != nullptr;
             s = state.slabs.get(s->next))
        {
          ++found.second;
        }
      });
  return found;
}

TEST(RollingWindow, GivesBackTheSlabsOfTilesThatLeaveByACorner)
{
  Params rolling;
  rolling.window_m = 20;
  State state = makeState(rolling, kCar);
  std::mt19937 random(11);
  const points::ScanBuffer scan = randomScan(random, 2000, 12);
  for (int i = 0; i < 50; ++i)
  {
    const double turned = 0.7 * i;  // over all four corners
    update(state, scan.view(), atPlace(8 * std::cos(turned), 8 * std::sin(turned)), rolling, kCar);
    ASSERT_EQ(sweptSize(state), std::pair(state.occupied, state.slabs.size())) << "scan " << i;
  }
}

TEST(RollingWindow, MemoryStaysFlatOnALongDrive)
{
  Params rolling;
  rolling.window_m = 20;
  State state = makeState(rolling, kCar);
  std::mt19937 random(10);
  const points::ScanBuffer scan = randomScan(random, 500);
  size_t early = 0;
  for (int i = 0; i < 1000; ++i)
  {
    update(state, scan.view(), atPlace(0.7 * i, 0.1 * i), rolling, kCar);
    early = std::max(early, i < 100 ? state.slabs.size() : 0);
    ASSERT_LE(state.slabs.size(), early + early / 4);
    ASSERT_LE(state.cells.tiles(), 25U);
  }
}
}  // namespace
