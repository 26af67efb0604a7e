// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/costmap.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

TEST(Costmap, ReadsOccupancyStates)
{
  const Costmap costmap = costsOf({occupancyOf({" .#v~"})}, withoutBuffers());
  EXPECT_EQ(passagesOf(costmap), (CostPicture{" .##."}));
  EXPECT_TRUE(std::isnan(costmap.obstacle_m[2]));
  EXPECT_EQ(costmap.obstacle_m[3], kFallsAway);
}

TEST(Costmap, ReadsTraversabilityClassesAndTheirSpeeds)
{
  CostParams params = withoutBuffers();
  params.small_roughness_mps = 1.5;
  params.large_roughness_mps = 0.5;
  const Costmap costmap = costsOf({classesOf({" 1234"})}, params);
  EXPECT_EQ(passagesOf(costmap), (CostPicture{" ...#"}));
  EXPECT_TRUE(std::isinf(costmap.speed_mps[0]));
  EXPECT_TRUE(std::isinf(costmap.speed_mps[1]));
  EXPECT_EQ(costmap.speed_mps[2], 1.5F);
  EXPECT_EQ(costmap.speed_mps[3], 0.5F);
}

TEST(Costmap, TakesCodesThatNobodyKnowsForNothing)
{
  layers::LayerSet set = classesOf({"1"});
  set.layers.front().data = std::vector<uint8_t>{200};
  EXPECT_EQ(passagesOf(costsOf({set}, withoutBuffers())), (CostPicture{" "}));
}

TEST(Costmap, AddsPricesOfIndexAndSlope)
{
  CostParams params = withoutBuffers();
  params.index_price = 4;
  params.slope_price = 2;
  layers::LayerSet set = classesOf({"1"});
  withLayer(withLayer(set, "traversability_index", 25), "slope_deg", 5);  // steepest: 20 deg
  EXPECT_FLOAT_EQ(costsOf({set}, params).price[0], 1 + 4 * 0.25F + 2 * 0.25F);
}

TEST(Costmap, TakesNoPriceFromValuesThatAreNone)
{
  layers::LayerSet set = classesOf({"1"});
  withLayer(withLayer(set, "traversability_index", kNoValue), "slope_deg", -3);
  EXPECT_EQ(costsOf({set}, withoutBuffers()).price[0], kLeastPrice);
}

TEST(Costmap, TakesASlopeAloneForNoObstacleAndNoMoreThanItsPrice)
{
  CostParams params = withoutBuffers();
  params.slope_price = 2;
  layers::LayerSet set = classesOf({"1"});
  const Costmap costmap = costsOf({withLayer(set, "slope_deg", 60)}, params);
  EXPECT_EQ(costmap.passage[0], Passage::open);
  EXPECT_FLOAT_EQ(costmap.price[0], 3);
}

TEST(Costmap, TellsSlopesByTheGroundAroundWhereItIsKnown)
{
  CostParams params = withoutBuffers();
  params.slope_price = 2;
  layers::LayerSet square = classesOf(CostPicture(9, "111111111"));
  std::vector<float> heights;
  for (size_t i = 0; i < square.size(); ++i)
  {
    heights.push_back(0.2F * 0.2F * static_cast<float>(i % 9));
  }
  square.layers.push_back({"ground_height", "m", std::move(heights)});
  withLayer(square, "slope_deg", 60);  // the noise of single cells does not count
  const Costmap costmap = costsOf({square}, params);
  const double steepest = geometry::tangentOf(20 * geometry::kPi / 180);
  for (size_t i = 0; i < costmap.size(); ++i)
  {
    // Floats of heights up to 0.4 m, over 0.6 m.
    ASSERT_NEAR(costmap.price[i], 1 + 2 * 0.2 / steepest, 1e-5) << "cell " << i;
  }
}

TEST(Costmap, PricesTheUnknownAndSoftBuffers)
{
  CostParams params = withoutBuffers();
  params.unknown_price = 3;
  params.soft_price = 5;
  params.hard_buffer_m = 0.2;
  params.soft_buffer_m = 0.2;
  const Costmap costmap = costsOf({occupancyOf({"#... "})}, params);
  EXPECT_EQ(passagesOf(costmap), (CostPicture{"#Hs. "}));
  EXPECT_EQ(costmap.price, (std::vector<float>{5, 5, 5, 1, 3}));
}

TEST(Costmap, GrowsHardThenSoftBuffers)
{
  CostParams params;
  params.hard_buffer_m = 0.2;
  params.soft_buffer_m = 0.2;
  EXPECT_EQ(
      passagesOf(costsOf(
          {occupancyOf({
              ".......",  //
              ".......",  //
              "...#...",  //
              ".......",  //
              ".......",
          })},
          params)),
      (CostPicture{
          "...s...",  //
          "..sHs..",  //
          ".sH#Hs.",  //
          "..sHs..",  //
          "...s..."}));
}

TEST(Costmap, GrowsBuffersIntoTheUnknownWhereItMayBePlannedThrough)
{
  CostParams params;
  params.hard_buffer_m = 0.2;
  params.soft_buffer_m = 0.2;
  params.unknown = UnknownPolicy::costly;
  EXPECT_EQ(passagesOf(costsOf({occupancyOf({"#     "})}, params)), (CostPicture{"#Hs   "}));
  params.unknown = UnknownPolicy::never;
  const Costmap never = costsOf({occupancyOf({"#     "})}, params);
  EXPECT_EQ(passagesOf(never), (CostPicture{"#     "}));
  EXPECT_FALSE(never.is_unknown_planned);
}

TEST(Costmap, KeepsHalfTheFootprintsWidthFromObstaclesByDefault)
{
  // 0.4 m and half a cell's diagonal, 0.141 m: 2 cells of 0.2 m, and (2, 1) at 0.447 m.
  CostParams params;
  params.soft_buffer_m = 0;
  EXPECT_NEAR(hardBuffer_m(params, {}, {200}), 0.4 + 0.2 * std::sqrt(0.5), 1e-12);
  EXPECT_EQ(
      passagesOf(costsOf(
          {occupancyOf({
              ".......",  //
              ".......",  //
              ".......",  //
              "...#...",
          })},
          params)),
      (CostPicture{
          ".......",  //
          "..HHH..",  //
          ".HHHHH.",  //
          ".HH#HH."}));
}

TEST(Costmap, CutsAStripWhereSoftBuffersMeet)
{
  CostParams params;
  params.hard_buffer_m = 0.2;
  params.soft_buffer_m = 1.0;
  const std::string wall(12, '#');
  const std::string free(12, '.');
  const CostPicture corridor = {wall, free, free, free, free, free, free, free, wall};
  const CostPicture cut = passagesOf(costsOf({occupancyOf(corridor)}, params));
  EXPECT_EQ(cut[4], free);
  params.strip = layers::StripRule::none;
  const CostPicture whole = passagesOf(costsOf({occupancyOf(corridor)}, params));
  EXPECT_EQ(whole[4], std::string(12, 's'));
}

TEST(Costmap, KnowsHeightsOfObstacles)
{
  layers::LayerSet map = classesOf({"4441"});
  const float none = kNoValue;
  map.layers.push_back({"ground_height", "m", std::vector<float>{5, none, none, 5}});
  map.layers.push_back({"height_min", "m", std::vector<float>{5.5F, 5.5F, none, 5}});
  map.layers.push_back({"height_max", "m", std::vector<float>{7, 7, none, 5.25F}});
  const Costmap costmap = costsOf({map}, withoutBuffers());
  EXPECT_EQ(costmap.obstacle_m[0], 2.0F);
  EXPECT_EQ(costmap.obstacle_m[1], 1.5F);  // of what was seen of it
  EXPECT_TRUE(std::isnan(costmap.obstacle_m[2]));
  EXPECT_TRUE(std::isnan(costmap.obstacle_m[3]));
}

TEST(Costmap, OpensTheUnknownUnderTheVehicleAndKeepsObstacles)
{
  // 1 m x 0.8 m around the middle of the picture, turned by a quarter.
  const CostPicture unseen = {
      "        ",  //
      "        ",  //
      "        ",  //
      "    #   ",  //
      "        ",  //
      "        ",  //
      "        "};
  const geometry::Pose2 stand = {0.8, 0.7, geometry::kPi / 2};
  EXPECT_EQ(
      passagesOf(costsOf({occupancyOf(unseen)}, withoutBuffers(), stand)),
      (CostPicture{
          "        ",  //
          "  ....  ",  //
          "  ....  ",  //
          "  ..#.  ",  //
          "  ....  ",  //
          "  ....  ",  //
          "        "}));
}

TEST(Costmap, ReadsGuaranteedOutlines)
{
  EXPECT_EQ(
      passagesOf(costsOf(
          {codeLayer("guaranteed_outline", {" x"}, " x"), occupancyOf({".."})}, withoutBuffers())),
      (CostPicture{".#"}));
}

TEST(Costmap, RefusesExtentsAndLayersThatAreNone)
{
  layers::LayerSet map = occupancyOf({"..."});
  const std::vector<MapLayers> maps = {{"map", &map}, {"none", nullptr}};
  const auto costs = [&](const geometry::CellRect& extent)
  { return costmapOf(maps, {200}, extent, {}, {}, {}); };
  EXPECT_NO_THROW(costs({{0, 0}, {3, 1}}));
  EXPECT_THROW(costs({{0, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(costs({{0, 0}, {4097, 1}}), std::invalid_argument);
  EXPECT_THROW(costs({{-2147483647, 0}, {2147483647, 1}}), std::invalid_argument);
  withLayer(map, "slope_deg", 0).layers.back().data = std::vector<float>{1};
  EXPECT_THROW(costs({{0, 0}, {3, 1}}), std::invalid_argument);
}
}  // namespace
