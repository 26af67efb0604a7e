// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Maps of pieces of a drive, merged, are the map of the drive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const geometry::Vehicle kCar;

struct Visit
{
  points::ScanBuffer scan;
  Eigen::Isometry3d T_map_base;
};

/** Many scans over few places, so that pieces share cells, slabs and tiles. */
std::vector<Visit> drive(std::mt19937& random, int scans)
{
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Visit> visits;
  visits.reserve(static_cast<size_t>(scans));
  for (int i = 0; i < scans; ++i)
  {
    visits.push_back(
        {randomScan(random, 300, 6),
         atPlace(9 * any(random), 9 * any(random), 0.4 * any(random), 3 * any(random))});
  }
  return visits;
}

Params of(Extent extent)
{
  Params params;
  params.extent = extent;
  params.fixed_min_x_m = params.fixed_min_y_m = -7;
  params.fixed_max_x_m = params.fixed_max_y_m = 5;
  return params;
}

/** The map of the visits for which `take(i)` holds. */
template <class Take>
Map mapOf(const std::vector<Visit>& visits, const Params& params, Take&& take)
{
  Map map{params, kCar, makeState(params, kCar)};
  for (size_t i = 0; i < visits.size(); ++i)
  {
    if (take(i))
    {
      update(map.state, visits[i].scan.view(), visits[i].T_map_base, params, kCar);
    }
  }
  return map;
}

std::string bytesOf(const Map& map)
{
  return archive(map.state, map.params, map.vehicle);
}

void mergeInto(Map& map, const Map& other)
{
  merge(map.state, map.params, map.vehicle, other);
}

/** These visits' map made of pieces: each visit to one of at most six, merged from the last to the
 * first.
 */
Map inPieces(const std::vector<Visit>& visits, const Params& params, std::mt19937& random)
{
  const size_t pieces = 1 + random() % 6;
  std::vector<size_t> piece_of(visits.size());
  for (size_t& piece : piece_of)
  {
    piece = random() % pieces;
  }
  Map merged{params, kCar, makeState(params, kCar)};
  for (size_t piece = pieces; piece-- > 0;)
  {
    const Map part = mapOf(visits, params, [&](size_t i) { return piece_of[i] == piece; });
    mergeInto(merged, fromArchive(bytesOf(part)));
  }
  return merged;
}

TEST(Merge, AnySplitOfADriveGivesTheWholeDrive)
{
  std::mt19937 random(31);
  for (const Extent extent : {Extent::growing, Extent::fixed})
  {
    const Params params = of(extent);
    for (int round = 0; round < 15; ++round)
    {
      const std::vector<Visit> visits = drive(random, 12);
      const Map whole = mapOf(visits, params, [](size_t) { return true; });
      const Map merged = inPieces(visits, params, random);
      ASSERT_EQ(bytesOf(merged), bytesOf(whole));
      EXPECT_EQ(
          classes(layerSet(merged.state, params, kCar)),
          classes(layerSet(whole.state, params, kCar)));
    }
  }
}

TEST(Merge, GoesOnAsTheWholeMapWould)
{
  std::mt19937 random(32);
  const Params params = of(Extent::growing);
  const std::vector<Visit> visits = drive(random, 9);
  Map merged = mapOf(visits, params, [](size_t i) { return i < 3; });
  mergeInto(merged, mapOf(visits, params, [](size_t i) { return i >= 3 && i < 6; }));
  for (size_t i = 6; i < visits.size(); ++i)
  {
    update(merged.state, visits[i].scan.view(), visits[i].T_map_base, params, kCar);
  }
  EXPECT_EQ(bytesOf(merged), bytesOf(mapOf(visits, params, [](size_t) { return true; })));
}

TEST(Merge, AnEmptyMapChangesNothing)
{
  std::mt19937 random(33);
  const Params params = of(Extent::growing);
  const std::vector<Visit> visits = drive(random, 3);
  Map map = mapOf(visits, params, [](size_t) { return true; });
  const std::string before = bytesOf(map);
  mergeInto(map, mapOf(visits, params, [](size_t) { return false; }));
  EXPECT_EQ(bytesOf(map), before);
}

TEST(Merge, OtherOptionsAreRefusedAndChangeNothing)
{
  std::mt19937 random(34);
  const std::vector<Visit> visits = drive(random, 2);
  const auto all = [](size_t) { return true; };
  Map map = mapOf(visits, of(Extent::growing), all);
  const std::string before = bytesOf(map);
  Params coarser = of(Extent::growing);
  coarser.cell_size_m = 0.4;
  Params stricter = of(Extent::growing);
  stricter.index_flat = 1;
  Map tall = mapOf(visits, of(Extent::growing), all);
  tall.vehicle.height_m = 3;
  for (const Map& other :
       {mapOf(visits, coarser, all), mapOf(visits, stricter, all), std::as_const(tall)})
  {
    EXPECT_THAT(
        [&] { mergeInto(map, other); },
        ThrowsMessage<std::invalid_argument>(HasSubstr("other options")));
    EXPECT_EQ(bytesOf(map), before);
  }
}

TEST(Merge, MapsThatForgetByOrderAreRefused)
{
  Params rolling = of(Extent::rolling);
  Params single = of(Extent::growing);
  single.mode = Mode::single_cloud;
  EXPECT_THAT(mergeObstacle(rolling), HasSubstr("growing"));
  EXPECT_THAT(mergeObstacle(single), HasSubstr("accumulated"));
  EXPECT_EQ(mergeObstacle(of(Extent::growing)), "");
  EXPECT_EQ(mergeObstacle(of(Extent::fixed)), "");
  for (const Params& params : {rolling, single})
  {
    Map map{params, kCar, makeState(params, kCar)};
    EXPECT_THROW(mergeInto(map, map), std::invalid_argument);
  }
}

TEST(Merge, BeyondTheBudgetIsAnErrorAndChangesNothing)
{
  Params params = of(Extent::growing);
  params.max_memory_mb = 1;
  const size_t tiles = mostTiles(params);
  std::vector<Visit> visits;
  for (size_t i = 0; i < tiles + 1; ++i)  // each in a tile of its own
  {
    points::ScanBuffer scan;
    addPoint(scan, 0.1, 0.1, 0);
    visits.push_back({scan, atPlace(10.0 * static_cast<double>(i), 0)});
  }
  Map map = mapOf(visits, params, [](size_t i) { return i == 0; });
  const std::string before = bytesOf(map);
  const Map rest = mapOf(visits, params, [](size_t i) { return i != 0; });
  EXPECT_THAT(
      [&] { mergeInto(map, rest); }, ThrowsMessage<std::length_error>(HasSubstr("max_memory_mb")));
  EXPECT_EQ(bytesOf(map), before);
}
}  // namespace
