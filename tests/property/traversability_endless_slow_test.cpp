// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <support/endless_drive.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;

/** 100 km, a cloud each 7.5 m, and 4 km more beside a young map; driven once for all tests. */
class EndlessDrive : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    drive = new Drive(with(Extent::rolling), 104'000, 7.5);
    early = drive->go(5.0 / 104);
    early_mb = residentMb();
    late = drive->go(100.0 / 104);
    late_mb = residentMb();
    ageing = drive->ageing();
  }

  static void TearDownTestSuite()
  {
    delete drive;
    drive = nullptr;
  }

  static inline Drive* drive = nullptr;
  static inline Size early, late;  // the first 5 km, with a full circle, and the rest to 100 km
  static inline double early_mb = 0, late_mb = 0;
  static inline double ageing = 0;
};

TEST_F(EndlessDrive, IsLongFarOutAndSeesAStreet)
{
  EXPECT_GT(drive->clouds(), 10'000U);
  EXPECT_GT(drive->farthest_m(), 50'000);
  EXPECT_GT(drive->leastPoints(), 3000U);
  const layers::LayerSet set = layerSet(drive->state(), drive->params(), kVan);
  const auto& of = std::get<std::vector<uint8_t>>(set.find(set.class_layer)->data);
  for (const Class c : {Class::flat, Class::obstacle})
  {
    EXPECT_GT(std::count(of.begin(), of.end(), static_cast<uint8_t>(c)), 1000);
  }
}

TEST_F(EndlessDrive, KeepsMemoryFlat)
{
  const auto side = static_cast<size_t>(drive->params().window_m / drive->params().cell_size_m);
  const size_t tiles = side / Cells::kSide + 2;  // along an edge, wherever the window lies
  EXPECT_LE(late.tiles, tiles * tiles);
  // The street repeats itself, its place on the lattice and its heights do not: a tenth for chance.
  EXPECT_LE(late.cells, early.cells * 11 / 10);
  EXPECT_LE(late.slabs, early.slabs * 11 / 10);
  EXPECT_LE(late.driven, early.driven * 11 / 10 + 1);
  // A tenth more slabs and some tiles, by chance, and the two lists of the test itself are 1 to
  // 2 MB; 200 bytes of each cloud left behind would be 2.5 MB.
  EXPECT_LT(late_mb - early_mb, 2.5);
  std::printf(
      "resident: %.1f MB after 5 km, %.1f MB after 100 km; most cells: %zu, %zu; tiles: %zu, %zu; "
      "slabs: %zu, %zu; driven cells: %zu, %zu\n",
      early_mb, late_mb, early.cells, late.cells, early.tiles, late.tiles, early.slabs, late.slabs,
      early.driven, late.driven);
}

// The check is against a young map in the same minutes: a tenth of the drive against another one
// measures the machine, by half as much again in a busy hour. The two maps do the same work, and
// differed by less than 1 % here; medians of some hundred clouds are that good.
constexpr double kMostAgeing = 1.15;

TEST_F(EndlessDrive, KeepsTimePerCloudFlat)
{
  EXPECT_LT(ageing, kMostAgeing);
  std::printf(
      "%zu points a cloud or more; median %.3f ms in the second tenth, %.3f ms in the last; "
      "%.3f times a young map's\n",
      drive->leastPoints(), drive->cpuMs(0.1, 0.2), drive->cpuMs(0.9, 1), ageing);
}

/** A layer's values; -1 where there is none. */
std::vector<double> valuesOf(const layers::LayerSet& set, const char* name)
{
  std::vector<double> values;
  const auto add = [&](double value) { values.push_back(std::isnan(value) ? -1 : value); };
  std::visit(
      [&](const auto& data) { std::for_each(data.begin(), data.end(), add); },
      set.find(name)->data);
  return values;
}

TEST_F(EndlessDrive, EndsWithTheMapOfWhatItSawLast)
{
  const size_t first = drive->firstThatCounts();
  EXPECT_LT(drive->clouds() - first, 100U) << "the fresh map is of the last window only";
  EXPECT_GT(drive->earlierVisits(), 0U) << "some cells left the window and came back";
  const State fresh = drive->fresh(first);
  EXPECT_TRUE(
      archive(drive->state(), drive->params(), kVan) == archive(fresh, drive->params(), kVan));
  const layers::LayerSet a = layerSet(drive->state(), drive->params(), kVan);
  const layers::LayerSet b = layerSet(fresh, drive->params(), kVan);
  ASSERT_EQ(a.extent, b.extent);
  for (const char* name : {"traversability_class", "traversability_index", "point_count"})
  {
    EXPECT_TRUE(valuesOf(a, name) == valuesOf(b, name)) << name;
  }
}

// Far more than a window's time: what leaves the window is not there any more to be forgotten.
TEST(EndlessDriveOfAForgetfulMap, KeepsMemoryFlat)
{
  Params params = with(Extent::rolling);
  params.forget_after_s = 10'000;
  Drive drive(params, 20'000, 7.5);
  const Size early = drive.go(0.25);
  const Size late = drive.go(1);
  EXPECT_LE(late.slabs, early.slabs * 11 / 10);
  EXPECT_LE(late.watched, early.tiles * 11 / 10) << "a tile that left is watched no more";
}

TEST(EndlessDriveOfAGrowingMap, KeepsTimePerCloudFlat)
{
  Drive drive(with(Extent::growing), 2200, 0.25);
  drive.go(2000.0 / 2200);
  EXPECT_GT(drive.state().driven.cells().size(), 2000U) << "it grows";
  EXPECT_GT(drive.state().occupied, 1'000'000U) << "it grows";
  const double ageing = drive.ageing();
  EXPECT_LT(ageing, kMostAgeing);
  std::printf(
      "%zu cells, %zu driven; median %.3f ms in the first tenth, %.3f ms in the last; %.3f times a "
      "young map's\n",
      drive.state().occupied, drive.state().driven.cells().size(), drive.cpuMs(0, 0.1),
      drive.cpuMs(0.9, 1), ageing);
}
}  // namespace
