// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/lead_in.h>
#include <traverse/navigation/motion.h>

#include <gtest/gtest.h>

namespace
{
using namespace traverse;
using navigation::Path;

TEST(LeadIn, GoesOnOnTheArcThatTheCarDrives)
{
  const Path lead = navigation::leadIn({1, 2, 0}, {1.5, 0.75});
  ASSERT_GT(lead.size(), 2U);
  EXPECT_NEAR(lead.back().along_m, 0.6, 1e-9) << "0.4 s at 1.5 m/s";
  EXPECT_NEAR(lead.back().pose.yaw_rad, 0.3, 1e-9);
  EXPECT_EQ(lead.front().curvature_1pm, 0.5);
  EXPECT_FALSE(lead.front().is_backward);
}

TEST(LeadIn, BackwardTurnsTheOtherWay)
{
  const Path lead = navigation::leadIn({0, 0, 0}, {-0.5, 0.1});
  EXPECT_NEAR(lead.back().pose.x_m, -0.2, 1e-3);
  EXPECT_NEAR(lead.back().pose.yaw_rad, 0.04, 1e-9);
  EXPECT_EQ(lead.front().curvature_1pm, -0.2) << "wheels to the right";
  EXPECT_TRUE(lead.front().is_backward);
}

TEST(LeadIn, ASlowCarHasNone)
{
  EXPECT_TRUE(navigation::leadIn({0, 0, 0}, {0.1, 0}).empty());
}

TEST(LeadIn, JoinsWithoutAGapOrAPlaceTwice)
{
  const Path lead = navigation::leadIn({0, 0, 0}, {1, 0});
  Path path;
  navigation::drive(path, navigation::posed(lead.back().pose), {0.5, 1});
  const Path whole = navigation::joined(lead, path);
  ASSERT_EQ(whole.size(), lead.size() + path.size() - 1);
  EXPECT_NEAR(whole.back().along_m, 1.4, 1e-9);
  for (size_t k = 1; k < whole.size(); ++k)
  {
    const double step_m = whole[k].along_m - whole[k - 1].along_m;
    EXPECT_GT(step_m, 0);
    EXPECT_NEAR(geometry::distance_m(whole[k - 1].pose, whole[k].pose), step_m, 1e-3);
  }
  EXPECT_EQ(whole[lead.size() - 2].curvature_1pm, 0);
  EXPECT_EQ(whole[lead.size() - 1].curvature_1pm, 0.5);
  EXPECT_TRUE(navigation::joined(lead, {}).empty());
  EXPECT_EQ(navigation::joined({}, path).size(), path.size());
}
}  // namespace
