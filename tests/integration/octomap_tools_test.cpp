// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The programs of Debian's octomap-tools read our files and see our leaves.
#include "support/octree_points.h"
#include "support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::HasSubstr;

#define NEEDS_OCTOMAP_TOOLS()                                             \
  do                                                                      \
  {                                                                       \
    if (!std::filesystem::exists("/usr/bin/convert_octree"))              \
    {                                                                     \
      GTEST_SKIP() << "SKIPPED: Debian package octomap-tools is missing"; \
    }                                                                     \
  } while (false)

formats::PointOctree sample()
{
  std::mt19937 random(4);
  std::vector<Point> points = randomPoints(random, 3000);
  for (int x = 0; x < 8; ++x)  // a solid block, which is pruned
  {
    for (int y = 0; y < 8; ++y)
    {
      for (int z = 0; z < 8; ++z)
      {
        points.push_back({5.05 + 0.1 * x, 5.05 + 0.1 * y, 0.05 + 0.1 * z});
      }
    }
  }
  return octreeOf(points);
}

TEST(OctomapTools, ConvertBothOfOurFilesIntoEachOther)
{
  NEEDS_OCTOMAP_TOOLS();
  const ScratchFolder scratch;
  const formats::PointOctree octree = sample();
  writeText(scratch / "our.bt", octree.bt());
  writeText(scratch / "our.ot", octree.ot());
  const Finished to_ot = run({"convert_octree", scratch / "our.bt", scratch / "their.ot"});
  const Finished to_bt = run({"convert_octree", scratch / "our.ot", scratch / "their.bt"});
  ASSERT_EQ(to_ot.exit_code, 0) << to_ot.err;
  ASSERT_EQ(to_bt.exit_code, 0) << to_bt.err;
  EXPECT_THAT(to_ot.err, Not(HasSubstr("ERROR")));
  EXPECT_THAT(to_bt.err, Not(HasSubstr("ERROR")));
  EXPECT_EQ(leavesOf(readText(scratch / "their.ot")), leavesOf(octree.bt()));
  EXPECT_EQ(leavesOf(readText(scratch / "their.bt")), leavesOf(octree.bt()));
}

TEST(OctomapTools, FindNoDifferenceBetweenOurTwoFiles)
{
  NEEDS_OCTOMAP_TOOLS();
  const ScratchFolder scratch;
  const formats::PointOctree octree = sample();
  writeText(scratch / "our.bt", octree.bt());
  writeText(scratch / "our.ot", octree.ot());
  ASSERT_EQ(run({"convert_octree", scratch / "our.bt", scratch / "their.ot"}).exit_code, 0);
  const Finished compared = run({"compare_octrees", scratch / "our.ot", scratch / "their.ot"});
  EXPECT_EQ(compared.exit_code, 0);
  EXPECT_THAT(compared.out + compared.err, HasSubstr("KLD: 0"));

  std::mt19937 random(99);
  writeText(scratch / "other.ot", octreeOf(randomPoints(random, 3000)).ot());
  const Finished other = run({"compare_octrees", scratch / "our.ot", scratch / "other.ot"});
  EXPECT_THAT(other.out + other.err, Not(HasSubstr("KLD: 0"))) << "it would notice";
}

TEST(OctomapTools, DrawOurLeavesWhereTheyAre)
{
  NEEDS_OCTOMAP_TOOLS();
  const ScratchFolder scratch;
  const formats::PointOctree octree = octreeOf({{1.23, -4.56, 7.89}, {0, 0, 0}});
  writeText(scratch / "our.bt", octree.bt());
  ASSERT_EQ(run({"bt2vrml", scratch / "our.bt"}).exit_code, 0);
  std::istringstream vrml(readText(scratch / "our.bt.wrl"));
  std::set<std::tuple<long, long, long>> centres_cm;
  for (std::string word; vrml >> word;)
  {
    if (word == "translation")
    {
      double x = 0;
      double y = 0;
      double z = 0;
      vrml >> x >> y >> z;
      centres_cm.emplace(std::lround(100 * x), std::lround(100 * y), std::lround(100 * z));
    }
  }
  EXPECT_EQ(centres_cm, (std::set<std::tuple<long, long, long>>{{125, -455, 785}, {5, 5, 5}}));
}
}  // namespace
