// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-map --rebuild: maps from the octree of earlier points, against the map of those points.
#include "support/grid_scenes.h"
#include "support/octree_points.h"
#include "support/traverse_map.h"

#include <traverse/traversability_grid/traversability_grid.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::HasSubstr;
using traversability_grid::Class;

const std::string kInsert = "Maps_CTraversabilityGridMap_00_insertOpts.";

/** Level ground of 24 x 24 m with 5 mm of noise, a wall, a kerb of 20 cm whose plateau goes on, and
 * a step of 6 cm within a row of cells; 100 points on each 0.2 m of ground, as in a drive. */
points::ScanBuffer scene()
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> along(-8, 8);
  std::normal_distribution<double> noise(0, 0.005);
  points::ScanBuffer scan;
  for (int i = 0; i < 320000; ++i)
  {
    const double x = along(random);
    const double y = along(random);
    const double kerb = x > 5.1 ? 0.2 : 0;
    const double step = y > 7.1 ? 0.06 : 0;
    addPoint(scan, x, y, kerb + step + noise(random));
  }
  for (int i = 0; i < 60000; ++i)
  {
    addPoint(scan, -6.1 + noise(random), along(random), along(random) / 8 + 1.01);
  }
  return scan;
}

struct Rebuilt
{
  Finished ran;
  nlohmann::json metrics;
  layers::LayerSet layers;
};

Rebuilt rebuild(
    const ScratchFolder& scratch, const std::string& file, const std::vector<std::string>& settings)
{
  writeText(scratch / "r.ini", "[Maps]\nCTraversabilityGridMap_count = 1\n");
  std::vector<std::string> arguments = {
      scratch / "r.ini", "--rebuild", scratch / file, "--output",
      scratch / "out",   "--force",   "--set",        kInsert + "extent=growing"};
  for (const std::string& setting : settings)
  {
    arguments.insert(arguments.end(), {"--set", setting});
  }
  Rebuilt result{traverseMap(arguments), {}, {}};
  if (result.ran.exit_code == 0)
  {
    result.metrics = metricsOf(scratch / "out");
    const auto map = traversability_grid::fromArchive(readText(scratch / "out" / "map.traverse"));
    result.layers = traversability_grid::layerSet(map.state, map.params, map.vehicle);
  }
  return result;
}

layers::LayerSet direct(const points::ScanBuffer& scan, double cell_size_m)
{
  traversability_grid::Params params;
  params.extent = traversability_grid::Extent::growing;
  params.cell_size_m = cell_size_m;
  const geometry::Vehicle vehicle;
  auto state = traversability_grid::makeState(params, vehicle);
  update(state, scan.view(), Eigen::Isometry3d::Identity(), params, vehicle);
  return layerSet(state, params, vehicle);
}

/** Share of the direct map's cells that have the same class in the other one. */
double sameClasses(const layers::LayerSet& a, const layers::LayerSet& b)
{
  EXPECT_EQ(a.extent, b.extent);
  const auto& one = std::get<std::vector<uint8_t>>(a.find("traversability_class")->data);
  const auto& two = std::get<std::vector<uint8_t>>(b.find("traversability_class")->data);
  size_t same = 0;
  for (size_t i = 0; i < std::min(one.size(), two.size()); ++i)
  {
    same += static_cast<size_t>(one[i] == two[i]);
  }
  return static_cast<double>(same) / static_cast<double>(one.size());
}

void save(const ScratchFolder& scratch, const points::ScanBuffer& scan, double resolution_m)
{
  formats::PointOctree octree({resolution_m, 2000});
  octree.insert(scan.view(), Eigen::Isometry3d::Identity());
  writeText(scratch / "m.bt", octree.bt());
  writeText(scratch / "m.ot", octree.ot());
}

double shareRebuilt(double resolution_m, const char* file, double cell_size_m)
{
  const ScratchFolder scratch;
  const points::ScanBuffer scan = scene();
  save(scratch, scan, resolution_m);
  const Rebuilt rebuilt =
      rebuild(scratch, file, {fmt::format("{}cell_size_m={}", kInsert, cell_size_m)});
  EXPECT_EQ(rebuilt.ran.exit_code, 0) << rebuilt.ran.err;
  EXPECT_EQ(rebuilt.layers.lattice.cell_m(), cell_size_m);
  const double share = sameClasses(direct(scan, cell_size_m), rebuilt.layers);
  ::testing::Test::RecordProperty("share", std::to_string(share));
  return share;
}

// Measured: 0.967 and 0.956 of the cells. Leaves of 2 cm move a height by 1 cm at most; cells whose
// highest point stands off the ground by nearly what `flat` allows (3 cm) change.
TEST(Rebuild, FromFineLeavesGivesTheDirectMapsClassesInNearlyAllCells)
{
  EXPECT_GT(shareRebuilt(0.02, "m.bt", 0.2), 0.95);
}

TEST(Rebuild, TakesCoarserCells)
{
  EXPECT_GT(shareRebuilt(0.02, "m.ot", 0.4), 0.94);
}

// Measured: 0.07. Ground whose noise falls into two layers of such leaves has a variance of 6.25
// cm^2 and is not flat any more: leaves must be finer than the heights that the limits tell apart.
TEST(Rebuild, FromLeavesCoarserThanTheLimitsDoesNot)
{
  EXPECT_LT(shareRebuilt(0.05, "m.bt", 0.2), 0.5);
}

TEST(Rebuild, TakesOtherThresholds)
{
  const ScratchFolder scratch;
  save(scratch, draw({"...lll..."}), 0.02);
  const Rebuilt strict = rebuild(scratch, "m.bt", {});
  const Rebuilt lenient = rebuild(
      scratch, "m.bt",
      {kInsert + "large_max_deviation_m=1", kInsert + "large_max_variance_m2=1",
       kInsert + "large_max_slope_deg=90", kInsert + "small_max_deviation_m=1",
       kInsert + "small_max_variance_m2=1", kInsert + "small_max_slope_deg=90"});
  ASSERT_EQ(lenient.ran.exit_code, 0) << lenient.ran.err;
  EXPECT_EQ(classes(strict.layers), Picture{"111333111"});
  EXPECT_EQ(classes(lenient.layers), Picture{"111222111"});
}

TEST(Rebuild, DoesNotDependOnTheSizeOfThePieces)
{
  const ScratchFolder scratch;
  std::mt19937 random(3);
  save(scratch, randomScan(random, 50000, 30), 0.05);
  // By the cells alone: the default classifier's ground starts in the middle of each piece.
  const Rebuilt large = rebuild(scratch, "m.bt", {kInsert + "classifier=paper"});
  const Rebuilt small =
      rebuild(scratch, "m.bt", {kInsert + "classifier=paper", kInsert + "window_m=3"});
  ASSERT_EQ(small.ran.exit_code, 0) << small.ran.err;
  EXPECT_GT(small.metrics["scans"], large.metrics["scans"]);
  EXPECT_EQ(small.metrics["maps"][0]["points"], large.metrics["maps"][0]["points"]);
  EXPECT_EQ(large.metrics["maps"][0]["points_outside"], 0);
  EXPECT_EQ(sameClasses(small.layers, large.layers), 1.0);
}

TEST(Rebuild, OfARebuiltMapsOctreeIsThatOctree)
{
  const ScratchFolder scratch;
  std::mt19937 random(4);
  save(scratch, randomScan(random, 5000, 10), 0.05);
  const Rebuilt rebuilt =
      rebuild(scratch, "m.ot", {"Maps_CTraversabilityGridMap_00_octomapOpts.resolution_m=0.05"});
  ASSERT_EQ(rebuilt.ran.exit_code, 0) << rebuilt.ran.err;
  EXPECT_EQ(readText(scratch / "out" / "map.bt"), readText(scratch / "m.bt"));
  EXPECT_EQ(readText(scratch / "out" / "map.ot"), readText(scratch / "m.ot"));
}

TEST(Rebuild, RefusesWhatCannotBeRebuilt)
{
  const ScratchFolder scratch;
  save(scratch, draw({"..."}), 0.05);
  const Rebuilt rolling = rebuild(scratch, "m.bt", {kInsert + "extent=rolling"});
  EXPECT_EQ(rolling.ran.exit_code, 3);
  EXPECT_THAT(rolling.ran.err, HasSubstr("extent = growing or fixed"));
  const Rebuilt narrow = rebuild(scratch, "m.bt", {kInsert + "window_m=1.2"});
  EXPECT_EQ(narrow.ran.exit_code, 3);
  EXPECT_THAT(narrow.ran.err, HasSubstr("window_m"));
  EXPECT_EQ(rebuild(scratch, "none.bt", {}).ran.exit_code, 4);
  writeText(scratch / "bad.bt", readText(scratch / "m.bt").substr(0, 100));
  const Rebuilt damaged = rebuild(scratch, "bad.bt", {});
  EXPECT_EQ(damaged.ran.exit_code, 4);
  EXPECT_THAT(damaged.ran.err, HasSubstr("octree"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
  const Finished both = traverseMap(
      {scratch / "r.ini", "--rebuild", scratch / "m.bt", "--rawlog", "x", "--output",
       scratch / "out"});
  EXPECT_EQ(both.exit_code, 2);
}
}  // namespace
