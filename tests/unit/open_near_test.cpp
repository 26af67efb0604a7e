// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/open_near.h>

#include <gtest/gtest.h>

#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

/** Cells of 1 m without buffers; the lower left one is (0, 0). */
Costmap drawn(const CostPicture& picture)
{
  return costsOf({occupancyOf(picture, 1000)}, withoutBuffers());
}

/** Column and row of the place next to the goal; (-1, -1): there is none. */
std::pair<int, int> nearOf(const Costmap& costmap, const Goal& goal, const geometry::Pose2& vehicle)
{
  const auto near = openNear(costmap, goal, vehicle);
  return near ? std::pair(static_cast<int>(near->x_m), static_cast<int>(near->y_m))
              : std::pair(-1, -1);
}

TEST(OpenNear, IsTheNearestOpenPlace)
{
  const Costmap costmap = drawn({
      ".....",  //
      "..##.",  //
      ".....",
  });
  EXPECT_EQ(nearOf(costmap, {3.5, 1.5, {}}, {0.5, 0.5, 0}), std::pair(3, 0));
}

TEST(OpenNear, IsAsFarFromTheGoalAsItMustButNearerThanTheVehicle)
{
  const std::string wide(12, '#');
  const Costmap costmap = drawn({
      "......" + wide,  //
      "......" + wide,  //
      "......" + wide,
  });
  EXPECT_EQ(nearOf(costmap, {15.5, 1.5, {}}, {0.5, 1.5, 0}), std::pair(5, 1));
  EXPECT_EQ(nearOf(costmap, {15.5, 1.5, {}}, {5.5, 1.5, 0}), std::pair(-1, -1));
}

TEST(OpenNear, CanBeReached)
{
  const Costmap costmap = drawn({
      "......####",  //
      "......#..#",  //
      "......####",
  });
  EXPECT_EQ(nearOf(costmap, {9.5, 1.5, {}}, {0.5, 1.5, 0}), std::pair(5, 1));
}

TEST(OpenNear, LeadsAwayOnlyWithinAFewMetres)
{
  const Costmap costmap = drawn({"..###"});
  EXPECT_EQ(nearOf(costmap, {4.5, 0.5, {}}, {0.5, 0.5, 0}), std::pair(1, 0));
  EXPECT_EQ(nearOf(costmap, {2.5, 0.5, {}}, {1.5, 0.5, 0}), std::pair(1, 0));  // stands there
}

TEST(OpenNear, HelpsAVehicleThatStandsTooNearToSomething)
{
  const Costmap costmap = drawn({"#....###"});
  EXPECT_EQ(nearOf(costmap, {7.5, 0.5, {}}, {0.5, 0.5, 0}), std::pair(4, 0));
}

TEST(OpenNear, IsNothingWhereTheVehicleIsNoWhere)
{
  const Costmap costmap = drawn({"..#"});
  EXPECT_EQ(nearOf(costmap, {2.5, 0.5, {}}, {500, 0.5, 0}), std::pair(-1, -1));
}
}  // namespace
