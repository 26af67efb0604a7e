// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/costmap.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

constexpr int32_t kColumns = 40;
constexpr int32_t kRows = 30;

/** Any states, mostly free and unknown; any prices. */
layers::LayerSet randomMap(std::mt19937& random)
{
  layers::LayerSet set = emptyLayers(kColumns, kRows, 200);
  std::discrete_distribution<int> code({30, 30, 1, 1, 1});
  std::uniform_real_distribution<float> share(0, 100);
  std::vector<uint8_t> states(set.size());
  std::vector<float> index(set.size());
  std::generate(states.begin(), states.end(), [&] { return static_cast<uint8_t>(code(random)); });
  std::generate(index.begin(), index.end(), [&] { return share(random); });
  set.layers.push_back({"occupancy_state", "1", std::move(states)});
  set.layers.push_back({"traversability_index", "1", std::move(index)});
  return set;
}

CostParams withoutStrip(UnknownPolicy unknown)
{
  CostParams params;
  params.strip = layers::StripRule::none;
  params.unknown = unknown;
  return params;
}

TEST(CostmapProperty, AnObstacleMakesNoCellBetter)
{
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round)
  {
    const CostParams params =
        withoutStrip(round % 2 == 0 ? UnknownPolicy::costly : UnknownPolicy::never);
    layers::LayerSet map = randomMap(random);
    const Costmap before = costsOf({map}, params);
    const size_t at = random() % map.size();
    auto& states = std::get<std::vector<uint8_t>>(map.layers.front().data);
    const bool was_known = states[at] != 0;
    states[at] = round % 3 == 0 ? 3 : 2;
    const Costmap after = costsOf({map}, params);
    for (size_t i = 0; i < map.size(); ++i)
    {
      ASSERT_GE(after.passage[i], before.passage[i]) << "cell " << i;
      // What is known is no longer priced as unknown; an obstacle's own price steers nobody.
      ASSERT_TRUE(after.price[i] >= before.price[i] || (i == at && !was_known)) << "cell " << i;
    }
    EXPECT_EQ(after.passage[at], Passage::obstacle);
  }
}

TEST(CostmapProperty, TwoMapsAreTheWorstOfBoth)
{
  std::mt19937 random(2);
  for (int round = 0; round < 40; ++round)
  {
    const CostParams params = withoutStrip(UnknownPolicy::costly);
    const layers::LayerSet a = randomMap(random);
    const layers::LayerSet b = randomMap(random);
    const Costmap of_a = costsOf({a}, params);
    const Costmap of_b = costsOf({b}, params);
    const Costmap both = costsOf({a, b}, params);
    for (size_t i = 0; i < both.size(); ++i)
    {
      const Passage worst = std::max(of_a.passage[i], of_b.passage[i]);
      const Passage least = std::min(of_a.passage[i], of_b.passage[i]);
      // What one map knows is known.
      const Passage expected =
          worst == Passage::unknown && least == Passage::open ? Passage::open : worst;
      ASSERT_EQ(both.passage[i], expected) << "cell " << i;
    }
  }
}

TEST(CostmapProperty, TheOrderOfMapsDoesNotMatter)
{
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round)
  {
    const layers::LayerSet a = randomMap(random);
    const layers::LayerSet b = randomMap(random);
    const Costmap forth = costsOf({a, b}, {});
    const Costmap back = costsOf({b, a}, {});
    EXPECT_EQ(forth.passage, back.passage);
    EXPECT_EQ(forth.price, back.price);
    EXPECT_EQ(forth.speed_mps, back.speed_mps);
  }
}

TEST(CostmapProperty, PricesAreFiniteAndNeverBelowTheLeast)
{
  std::mt19937 random(4);
  for (int round = 0; round < 40; ++round)
  {
    const Costmap costmap = costsOf({randomMap(random)}, {});
    const auto [least, most] = std::minmax_element(costmap.price.begin(), costmap.price.end());
    EXPECT_GE(*least, kLeastPrice);
    EXPECT_LE(*most, 1 + 4 + 4 + 2);  // ground, soft_price - 1, index_price, unknown_price - 1
  }
}

TEST(CostmapProperty, AMapOfHalfTheCellSizeSaysTheSame)
{
  std::mt19937 random(5);
  for (int round = 0; round < 10; ++round)
  {
    const layers::LayerSet coarse = randomMap(random);
    layers::LayerSet fine = emptyLayers(2 * kColumns, 2 * kRows, 100);
    std::vector<uint8_t> states(fine.size());
    const auto& theirs = std::get<std::vector<uint8_t>>(coarse.layers.front().data);
    for (size_t i = 0; i < states.size(); ++i)
    {
      const size_t x = i % (2 * kColumns) / 2;
      const size_t y = i / (2 * kColumns) / 2;
      states[i] = theirs[y * kColumns + x];
    }
    fine.layers.push_back({"occupancy_state", "1", std::move(states)});
    const Costmap by_fine = costmapOf(
        std::vector<MapLayers>{{"fine", &fine}}, coarse.lattice, coarse.extent, kFarAway,
        geometry::Vehicle{}, CostParams{});
    EXPECT_EQ(by_fine.passage, costsOf({coarse}, {}).passage);
  }
}
}  // namespace
