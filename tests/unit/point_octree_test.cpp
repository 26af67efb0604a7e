// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <support/octree_points.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using formats::OctomapParams;
using formats::PointOctree;
using ::testing::HasSubstr;

TEST(PointOctree, APointOccupiesTheHalfOpenLeafThatItIsIn)
{
  const PointOctree octree = octreeOf({{0, 0, 0}, {0.1, -0.1, 0.0999}, {-0.0004, -0.0996, 0.5}});
  // The third is quantised to the millimetre first, as in the maps: x to 0, y to -0.1.
  EXPECT_EQ(
      leavesOf(octree.bt()),
      (std::set<Leaf>{{32768, 32768, 32768}, {32769, 32767, 32769}, {32768, 32767, 32773}}));
  EXPECT_EQ(leavesOf(octree.ot()), leavesOf(octree.bt()));
  EXPECT_NEAR(formats::leafCentre_m(32769, 0.1), 0.15, 1e-12) << "rounding of doubles";
}

TEST(PointOctree, PointsAreTakenThroughThePose)
{
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).matrix();
  T_map_base.translation() = Eigen::Vector3d(10, 0, 1);
  PointOctree octree({0.1, 100});
  octree.insert(scanOf({{2.05, 1.05, 0.05}}).view(), T_map_base);
  EXPECT_EQ(leavesOf(octree.bt()), (std::set<Leaf>{{32768 + 89, 32768 + 20, 32768 + 10}}));
}

TEST(PointOctree, BytesDoNotDependOnTheOrderOfScansOrOnHowOftenALeafIsHit)
{
  std::mt19937 random(1);
  std::vector<std::vector<Point>> scans(12);
  for (std::vector<Point>& scan : scans)
  {
    scan = randomPoints(random, 3000);
  }
  std::string bt;
  std::string ot;
  for (int round = 0; round < 3; ++round)
  {
    PointOctree octree({0.05, 100});
    for (const auto& scan : scans)
    {
      octree.insert(scanOf(scan).view(), Eigen::Isometry3d::Identity());
      if (round == 1)
      {
        octree.bt();  // looked at in between: leaves that are eight equal ones are joined early
      }
    }
    bt = round == 0 ? octree.bt() : bt;
    ot = round == 0 ? octree.ot() : ot;
    EXPECT_EQ(octree.bt(), bt) << round;
    EXPECT_EQ(octree.ot(), ot) << round;
    std::shuffle(scans.begin(), scans.end(), random);
    scans.push_back(scans.front());
  }
}

TEST(PointOctree, EightEqualLeavesAreOneInTheFileAndEightWhenRead)
{
  std::vector<Point> cube(64);
  for (size_t i = 0; i < cube.size(); ++i)
  {
    const size_t x = i % 4;
    const size_t y = i / 4 % 4;
    const size_t z = i / 16;
    cube[i] = {
        0.05 + 0.1 * static_cast<double>(x), 0.05 + 0.1 * static_cast<double>(y),
        0.05 + 0.1 * static_cast<double>(z)};
  }
  const PointOctree octree = octreeOf(cube);
  EXPECT_EQ(leavesOf(octree.bt()).size(), 64U);
  EXPECT_EQ(leavesOf(octree.bt()), leavesOf(octree.ot()));
  EXPECT_EQ(formats::checkOctree(octree.ot()).nodes, 15U) << "root to the node of 0.4 m, no deeper";
}

TEST(PointOctree, PointsThatHaveNoLeafAreCountedAndTold)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const PointOctree octree = octreeOf(
      {{nan, 0, 0}, {0, inf, 0}, {1e9, 0, 0}, {3276.7, 0, 0}, {3276.85, 0, 0}, {0, 0, -3277}});
  EXPECT_EQ(octree.counts().bad_points, 3U);
  EXPECT_EQ(octree.counts().beyond, 2U);
  EXPECT_EQ(octree.counts().points, 1U);
  ASSERT_EQ(octree.warnings().size(), 1U);
  EXPECT_THAT(octree.warnings()[0], HasSubstr("3276.8 m"));
}

TEST(PointOctree, TheMemoryLimitHoldsAndIsTold)
{
  std::mt19937 random(2);
  PointOctree octree({0.05, 1});
  octree.insert(scanOf(randomPoints(random, 100000, 20)).view(), Eigen::Isometry3d::Identity());
  EXPECT_GT(octree.counts().over_budget, 50000U);
  EXPECT_EQ(octree.counts().points + octree.counts().over_budget, 100000U);
  EXPECT_LE(formats::checkOctree(octree.ot()).nodes, 1'000'000U / 88);
  ASSERT_EQ(octree.warnings().size(), 1U);
  EXPECT_THAT(octree.warnings()[0], HasSubstr("max_memory_mb"));
}

TEST(PointOctree, IsOffWithoutAResolution)
{
  PointOctree octree;
  octree.insert(scanOf({{1, 2, 3}}).view(), Eigen::Isometry3d::Identity());
  EXPECT_TRUE(octree.empty());
  EXPECT_TRUE(octree.files().empty());
}

TEST(PointOctree, FilesAreThereOnceThereArePoints)
{
  EXPECT_TRUE(PointOctree({0.1, 10}).files().empty());
  const auto files = octreeOf({{0, 0, 0}}).files();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].ending, ".bt");
  EXPECT_EQ(files[1].ending, ".ot");
}

TEST(PointOctree, ACopySharesNothing)
{
  PointOctree octree = octreeOf({{0, 0, 0}});
  const PointOctree copy = octree;
  octree.insert(scanOf({{1, 1, 1}}).view(), Eigen::Isometry3d::Identity());
  EXPECT_EQ(leavesOf(copy.bt()).size(), 1U);
  EXPECT_EQ(leavesOf(octree.bt()).size(), 2U);
}

TEST(PointOctree, ComesBackFromItsBinaryFile)
{
  std::mt19937 random(3);
  const std::vector<Point> points = randomPoints(random, 5000, 0.4);
  PointOctree octree = octreeOf(points);
  PointOctree back = PointOctree::fromBt(octree.bt(), {0.1, 100});
  EXPECT_EQ(back.ot(), octree.ot());
  for (PointOctree* each : {&octree, &back})
  {
    each->insert(scanOf(randomPoints(random, 0)).view(), Eigen::Isometry3d::Identity());
    each->insert(scanOf({{2, 2, 2}, points[0]}).view(), Eigen::Isometry3d::Identity());
  }
  EXPECT_EQ(back.ot(), octree.ot()) << "and goes on";
  EXPECT_THROW(PointOctree::fromBt(octree.bt(), {0.2, 100}), formats::FormatError);
  EXPECT_THROW(PointOctree::fromBt(octree.bt(), {}), formats::FormatError);
}

TEST(PointOctree, MergesToTheOctreeOfAllPoints)
{
  std::mt19937 random(5);
  const std::vector<Point> first = randomPoints(random, 4000);
  std::vector<Point> second = randomPoints(random, 4000);
  second.insert(second.end(), first.begin(), first.begin() + 100);
  PointOctree merged({0.1, 100});
  merged.merge(octreeOf(second).bt());
  merged.merge(octreeOf(first).bt());
  std::vector<Point> all = first;
  all.insert(all.end(), second.begin(), second.end());
  EXPECT_EQ(merged.bt(), octreeOf(all).bt());
  EXPECT_EQ(merged.ot(), octreeOf(all).ot());
  EXPECT_THROW(merged.merge(octreeOf(first, 0.2).bt()), formats::FormatError);
}

TEST(PointOctree, OptionsChangeOnlyWhileItIsEmpty)
{
  PointOctree octree;
  octree.adopt({0.1, 100});
  octree.insert(scanOf({{0, 0, 0}}).view(), Eigen::Isometry3d::Identity());
  EXPECT_NO_THROW(octree.adopt({0.1, 50}));
  EXPECT_THROW(octree.adopt({0.2, 50}), std::invalid_argument);
  EXPECT_FALSE(octree.empty());
}

TEST(OctomapParams, RefusesResolutionsThatMakeNoSense)
{
  for (const double good : {0.0, 0.005, 0.05, 0.2})
  {
    EXPECT_NO_THROW(formats::check({good, 100}, 0.2)) << good;
  }
  for (const double bad : {-0.1, 0.004, 0.0505, 0.201, 11.0})
  {
    EXPECT_THROW(formats::check({bad, 100}, 0.2), options::OptionError) << bad;
  }
}
}  // namespace
