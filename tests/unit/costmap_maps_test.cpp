// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/costmap.h>

#include <gtest/gtest.h>

#include <string>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

TEST(CostmapOfMaps, TellsSlopesOfWindowsAsOfWholeMaps)
{
  // A window's first and last columns have neighbours in the map; holes in the ground everywhere.
  layers::LayerSet map = classesOf(CostPicture(20, std::string(20, '1')));
  std::vector<float> heights;
  for (uint32_t i = 0; i < map.size(); ++i)
  {
    const uint32_t mixed = i * 2654435761U >> 16U;
    heights.push_back(mixed % 5 == 0 ? kNoValue : static_cast<float>(mixed % 97) / 1000);
  }
  map.layers.push_back({"ground_height", "m", std::move(heights)});
  withLayer(map, "slope_deg", 7);
  const std::vector<MapLayers> maps = {{"map", &map}};
  const Costmap whole = costsOf({map}, withoutBuffers());
  const Costmap part = costmapOf(
      maps, map.lattice, {{2, 1}, {19, 18}}, kFarAway, geometry::Vehicle{}, withoutBuffers());
  for (geometry::CellIndex c = part.extent.min; c.y < part.extent.max.y; ++c.y)
  {
    for (c.x = part.extent.min.x; c.x < part.extent.max.x; ++c.x)
    {
      ASSERT_EQ(part.price[part.indexOf(c)], whole.price[whole.indexOf(c)]) << c.x << " " << c.y;
    }
  }
  // explainCost() counts cell by cell; texts have three decimals.
  for (int32_t x = 0; x < 20; ++x)
  {
    const std::string told =
        explainCost(maps, whole, 0.1 + 0.2 * x, 1.9, geometry::Vehicle{}, withoutBuffers())[2]
            .value;
    const size_t at = told.find("price + ");
    ASSERT_NE(at, std::string::npos) << told;
    EXPECT_NEAR(
        std::stod(told.substr(at + 8)), whole.price[whole.indexOf({x, 9})] - kLeastPrice, 1e-3);
  }
}

TEST(CostmapOfMaps, GrowsOneBufferAroundTheObstaclesOfAllMaps)
{
  CostParams params;
  params.hard_buffer_m = 0.2;
  params.soft_buffer_m = 0.8;
  // Each map knows one wall: the strip is between both.
  const std::string wall(12, '#');
  const std::string free(12, '.');
  const CostPicture upper = {wall, free, free, free, free, free, free, free, free};
  const CostPicture lower = {free, free, free, free, free, free, free, free, wall};
  const CostPicture both = {wall, free, free, free, free, free, free, free, wall};
  EXPECT_EQ(
      passagesOf(costsOf({occupancyOf(upper), occupancyOf(lower)}, params)),
      passagesOf(costsOf({occupancyOf(both)}, params)));
}

TEST(CostmapOfMaps, KnowsWhatAnyMapKnows)
{
  EXPECT_EQ(
      passagesOf(costsOf({occupancyOf({" .#  .#"}), classesOf({"   1414"})}, withoutBuffers())),
      (CostPicture{" .#.#.#"}));
}

TEST(CostmapOfMaps, CountsWhatMapsOfOneKindSayOnce)
{
  CostParams params = withoutBuffers();
  params.index_price = 4;
  layers::LayerSet easy = classesOf({"1"});
  layers::LayerSet hard = classesOf({"1"});
  withLayer(easy, "traversability_index", 10);
  withLayer(hard, "traversability_index", 50);
  EXPECT_FLOAT_EQ(costsOf({easy, hard}, params).price[0], 3);
  EXPECT_FLOAT_EQ(costsOf({hard, easy}, params).price[0], 3);
}

TEST(CostmapOfMaps, CountsAllCellsOfFinerMaps)
{
  const layers::LayerSet fine = occupancyOf(
      {"...... ",  //
       "..#... "},
      100);
  const Costmap costmap = costmapOf(
      std::vector<MapLayers>{{"fine", &fine}}, {200}, {{0, 0}, {5, 1}}, kFarAway, {},
      withoutBuffers());
  EXPECT_EQ(passagesOf(costmap), (CostPicture{".#.  "}));
}

TEST(CostmapOfMaps, TakesTheWorstPriceOfFinerCellsOnce)
{
  CostParams params = withoutBuffers();
  params.index_price = 4;
  layers::LayerSet fine = classesOf({"11", "11"}, 100);
  fine.layers.push_back({"traversability_index", "1", std::vector<float>{10, 20, 50, kNoValue}});
  const Costmap costmap = costmapOf(
      std::vector<MapLayers>{{"fine", &fine}}, {200}, {{0, 0}, {1, 1}}, kFarAway, {}, params);
  EXPECT_FLOAT_EQ(costmap.price[0], 3);
}

TEST(CostmapOfMaps, CountsAllCellsOfMapsOnOtherLattices)
{
  // Cells of 0.3 m over cells of 0.2 m; negative indices too.
  layers::LayerSet coarse = emptyLayers(2, 1, 300, {-1, 0});
  coarse.layers.push_back({"occupancy_state", "1", std::vector<uint8_t>{2, 1}});
  const Costmap costmap = costmapOf(
      std::vector<MapLayers>{{"coarse", &coarse}}, {200}, {{-3, 0}, {3, 2}}, kFarAway, {},
      withoutBuffers());
  EXPECT_EQ(passagesOf(costmap), (CostPicture{" ##.. ", " ##.. "}));
}

TEST(CostmapOfMaps, ReadsWhatMapAndWindowShare)
{
  const layers::LayerSet map = occupancyOf({"#..", "..."});
  const Costmap costmap = costmapOf(
      std::vector<MapLayers>{{"map", &map}}, {200}, {{-1, 1}, {2, 3}}, kFarAway, {},
      withoutBuffers());
  EXPECT_EQ(passagesOf(costmap), (CostPicture{"   ", " #."}));
}
}  // namespace
