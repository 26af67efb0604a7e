// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/costmap.h>

#include <gtest/gtest.h>

#include <limits>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

/** What is said of the cell in the given column of one row of cells, as "key: value" lines. */
std::string explained(
    const std::vector<MapLayers>& maps,
    double x_m,
    const CostParams& params,
    const geometry::Pose2& stand = kFarAway)
{
  const layers::LayerSet& first = *maps.front().set;
  const Costmap costmap = costmapOf(maps, first.lattice, first.extent, stand, {}, params);
  std::string text;
  for (const layers::Fact& fact : explainCost(maps, costmap, x_m, 0.1, {}, params))
  {
    text += fact.key + " = " + fact.value + "\n";
  }
  return text;
}

CostParams narrow()
{
  CostParams params;
  params.hard_buffer_m = 0.2;
  params.soft_buffer_m = 0.2;
  return params;
}

TEST(ExplainCost, SaysWhatEachLayerOfEachMapAdds)
{
  layers::LayerSet ground = classesOf({"1113"});
  withLayer(withLayer(ground, "traversability_index", 50), "slope_deg", 10);
  const layers::LayerSet lidars = occupancyOf({"#..."});
  EXPECT_EQ(
      explained({{"ground", &ground}, {"lidars", &lidars}}, 0.7, narrow()),
      "cell = 3, 0 of 0.2 m\n"
      "ground: traversability_class = 3: may be driven, at 0.5 m/s at most\n"
      "ground: traversability_index = 50: price + 2\n"
      "ground: slope = 10 deg by slope_deg: price + 1\n"
      "lidars: occupancy_state = 1: may be driven\n"
      "buffer = none: no obstacle within 0.4 m\n"
      "sum = open, 4 a metre, at 0.5 m/s at most\n");
}

TEST(ExplainCost, SaysWhichBufferACellIsIn)
{
  const layers::LayerSet map = occupancyOf({"#..."});
  EXPECT_EQ(
      explained({{"map", &map}}, 0.5, narrow()),
      "cell = 2, 0 of 0.2 m\n"
      "map: occupancy_state = 1: may be driven\n"
      "buffer = nearest obstacle 0.4 m away: hard up to 0.2 m, soft up to 0.4 m\n"
      "sum = soft buffer (price + 4), 5 a metre\n");
}

TEST(ExplainCost, SaysWhereAStripIsCut)
{
  CostParams params = narrow();
  params.soft_buffer_m = 1;
  const std::string wall(12, '#');
  const std::string free(12, '.');
  const layers::LayerSet map = occupancyOf({wall, free, free, free, free, free, free, free, wall});
  const std::vector<MapLayers> maps = {{"map", &map}};
  const Costmap costmap = costsOf({map}, params);
  EXPECT_EQ(
      explainCost(maps, costmap, 1.1, 0.9, {}, params)[2].value,
      "nearest obstacle 0.8 m away: hard up to 0.2 m, soft up to 1.2 m; a strip is cut free where "
      "soft buffers meet");
}

TEST(ExplainCost, SaysHowHighAnObstacleIsAndWhatFallsAway)
{
  layers::LayerSet high = classesOf({"4"});
  withLayer(withLayer(high, "height_max", 1.5), "ground_height", 0.25);
  const layers::LayerSet ditch = occupancyOf({"v"});
  EXPECT_NE(
      explained({{"map", &high}}, 0.1, narrow())
          .find("sum = obstacle (price + 4), 5 a metre, 1.25 m high\n"),
      std::string::npos);
  EXPECT_NE(
      explained({{"map", &ditch}}, 0.1, narrow())
          .find("map: occupancy_state = 3: obstacle, the ground falls away\n"),
      std::string::npos);
}

TEST(ExplainCost, SaysWhatTheVehicleStandsOn)
{
  const layers::LayerSet map = occupancyOf({"   #     "});
  const geometry::Pose2 stand = {0.7, 0.1, 0};
  EXPECT_NE(
      explained({{"map", &map}}, 0.7, narrow(), stand)
          .find("vehicle = stands over all of it: the obstacle is false, or hit already\n"),
      std::string::npos);
  EXPECT_NE(
      explained({{"map", &map}}, 0.5, narrow(), stand)
          .find("vehicle = stands there: open where no map knows better\n"),
      std::string::npos);
}

TEST(ExplainCost, SaysWhatTheUnknownCosts)
{
  CostParams params = narrow();
  const layers::LayerSet map = occupancyOf({"#      "});
  EXPECT_NE(
      explained({{"map", &map}}, 1.3, params).find("sum = unknown (price + 2), 3 a metre\n"),
      std::string::npos);
  params.unknown = UnknownPolicy::never;
  EXPECT_NE(
      explained({{"map", &map}}, 0.3, params).find("the unknown has no buffer\n"),
      std::string::npos);
  EXPECT_NE(
      explained({{"map", &map}}, 1.3, params).find("sum = unknown (never planned through)"),
      std::string::npos);
}

TEST(ExplainCost, AnswersForPlacesOutside)
{
  const layers::LayerSet map = occupancyOf({"#."});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x_m : {-0.1, 0.4, 1e5, 1e300, -1e300, nan})
  {
    EXPECT_NE(
        explained({{"map", &map}}, x_m, narrow()).find("sum = outside of the costmap\n"),
        std::string::npos);
  }
}
}  // namespace
