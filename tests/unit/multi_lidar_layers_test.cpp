// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/fusion.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <support/occupancy_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using namespace traverse::multi_lidar_grid;
using ::testing::Each;
using ::testing::ElementsAre;

constexpr std::string_view kStates = " .#vn";
constexpr std::string_view kView = " .#vn+";
constexpr geometry::CellRect kFiveByTwo{{0, 0}, {5, 2}};

template <class T>
const std::vector<T>& dataOf(const layers::LayerSet& set, std::string_view name)
{
  return std::get<std::vector<T>>(set.find(name)->data);
}

TEST(MultiLidarLayers, ShowTheAccumulatedStates)
{
  Map map = smallMap();
  accumulate(map, {".#vn ", "....."}, 1);
  const layers::LayerSet set = layersOf(map, kFiveByTwo);
  EXPECT_THAT(drawn(set, "occupancy_state", kStates), ElementsAre(".#vn ", "....."));
  EXPECT_EQ(set.class_layer, "occupancy_view");
}

TEST(MultiLidarLayers, TellFreeSeenByOneFromFreeSeenBySeveral)
{
  Map map = smallMap();
  accumulate(map, {".#.. ", "....."}, 1);
  accumulate(map, {"...", "  "}, 2);
  accumulate(map, {" #   ", "     "}, 2);
  EXPECT_THAT(
      drawn(layersOf(map, kFiveByTwo), "occupancy_view", kView), ElementsAre("+#+. ", "....."));
}

TEST(MultiLidarLayers, AnEmptyMapHasNoCells)
{
  const Params params;
  const geometry::Vehicle vehicle;
  const layers::LayerSet set = layerSet(State(params, vehicle), params, vehicle);
  EXPECT_TRUE(set.extent.empty());
  EXPECT_EQ(set.size(), 0U);
}

TEST(MultiLidarLayers, HaveTheSizeOfTheRegionOrTheWindow)
{
  const Map map = smallMap();
  for (const auto& window : {std::optional<geometry::CellRect>{}, std::optional(kFiveByTwo)})
  {
    const layers::LayerSet set = layersOf(map, window);
    EXPECT_EQ(set.extent, window.value_or(map.state.cells.region()));
    for (const layers::Layer& layer : set.layers)
    {
      EXPECT_EQ(std::visit([](const auto& data) { return data.size(); }, layer.data), set.size())
          << layer.name;
    }
  }
}

TEST(MultiLidarLayers, AreUnknownOutsideTheRegion)
{
  Map map = smallMap();
  const geometry::CellRect region = map.state.cells.region();
  map.state.cells.fill(region, {layers::OccupancyState::free});
  // One side further, where a torus would show the same memory.
  for (const int32_t far : {32, 1'000'000, 2'000'000'000})
  {
    const geometry::CellRect window{{far, far}, {far + 3, far + 3}};
    EXPECT_THAT(dataOf<uint8_t>(layersOf(map, window), "occupancy_state"), Each(0));
    EXPECT_THAT(dataOf<uint8_t>(layersOf(map, window), "safety_buffer"), Each(0));
  }
}

TEST(MultiLidarLayers, RefuseWindowsBeyondMemory)
{
  const Map map = smallMap();
  constexpr int32_t kLeast = std::numeric_limits<int32_t>::min();
  constexpr int32_t kMost = std::numeric_limits<int32_t>::max();
  EXPECT_THROW(
      layersOf(map, geometry::CellRect{{kLeast, kLeast}, {kMost, kMost}}), std::length_error);
  EXPECT_THROW(layersOf(map, geometry::CellRect{{0, 0}, {20'000, 20'000}}), std::length_error);
  EXPECT_EQ(layersOf(map, geometry::CellRect{{5, 5}, {3, 9}}).size(), 0U);
}

TEST(MultiLidarLayers, SayUpToWhichHeightAndHowLongAgo)
{
  Map map = smallMap();
  accumulate(map, {".# "}, 1);
  const layers::LayerSet set = layersOf(map, geometry::CellRect{{0, 0}, {3, 1}});
  const auto& heights = dataOf<float>(set, "free_height");
  EXPECT_FLOAT_EQ(heights[0], static_cast<float>(5 * kFreeStep_m));
  EXPECT_TRUE(std::isnan(heights[1]));
  EXPECT_TRUE(std::isnan(heights[2]));
  const auto& ages = dataOf<float>(set, "last_seen_age");
  EXPECT_FLOAT_EQ(ages[0], 2);
  EXPECT_FLOAT_EQ(ages[1], 2);
  EXPECT_TRUE(std::isnan(ages[2]));
}

TEST(MultiLidarLayers, TheLatestCloudsAreFusedByTheStrongerWord)
{
  Map map = smallMap();
  addCloud(map, "left", {"..#. ", "n.v. "});
  addCloud(map, "right", {".#.  ", ".vv. "});
  const layers::LayerSet set = layersOf(map, kFiveByTwo);
  EXPECT_THAT(drawn(set, "occupancy_latest", kStates), ElementsAre(".##. ", "nvv. "));
  EXPECT_THAT(dataOf<uint32_t>(set, "latest_mask"), ElementsAre(3, 3, 3, 3, 0, 3, 3, 3, 1, 0));
}

TEST(MultiLidarLayers, ASilentSensorsLatestCloudNoLongerCounts)
{
  Map map = smallMap();
  addCloud(map, "left", {"..."});
  addCloud(map, "right", {"##."}, 1.01 * map.params.timeout_s);
  const layers::LayerSet set = layersOf(map, geometry::CellRect{{0, 0}, {3, 1}});
  EXPECT_THAT(drawn(set, "occupancy_latest", kStates), ElementsAre("..."));
  EXPECT_THAT(dataOf<uint32_t>(set, "latest_mask"), ElementsAre(1, 1, 1));
}

TEST(MultiLidarLayers, ObstaclesBesideTheWindowReachIntoIt)
{
  Map map = smallMap();
  map.params.hard_buffer_m = 0.5;
  map.params.soft_buffer_m = 1;
  const geometry::CellRect region = map.state.cells.region();
  map.state.cells.fill(region, {layers::OccupancyState::free});
  map.state.cells.at({0, 0}).state = layers::OccupancyState::obstacle;
  const layers::LayerSet all = layersOf(map);
  const layers::LayerSet part = layersOf(map, geometry::CellRect{{1, 0}, {5, 1}});
  const auto& zones = dataOf<uint8_t>(part, "safety_buffer");
  const auto& whole = dataOf<uint8_t>(all, "safety_buffer");
  const auto row = static_cast<size_t>(-region.min.y) * static_cast<size_t>(region.width());
  for (size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(zones[i], whole[row + static_cast<size_t>(1 - region.min.x) + i]) << i;
  }
  EXPECT_EQ(zones[0], static_cast<uint8_t>(layers::BufferZone::hard));
  EXPECT_EQ(zones[3], static_cast<uint8_t>(layers::BufferZone::none));
}

TEST(MultiLidarLayers, BlockedAreObstaclesAndDitchesAndNothingElse)
{
  const layers::LayerSet set = layersOf(smallMap());
  EXPECT_THAT(set.blocked_codes, ElementsAre(2, 3));
  EXPECT_EQ(set.legend.size(), 6U);
}
}  // namespace
