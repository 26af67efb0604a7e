// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/cost_rules.h>
#include <traverse/navigation/grip.h>
#include <traverse/navigation/motion_guard.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <support/cost_pictures.h>

namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;

constexpr size_t kColumns = 210;

/** Differences of rounding only. */
constexpr double kRounding = 1e-6;

/** Three rows of free cells of 0.1 m; `friction` in the columns from..to, not known elsewhere. */
layers::LayerSet ground(float friction, size_t from, size_t to)
{
  const std::string free(kColumns, '.');
  layers::LayerSet set = occupancyOf({free, free, free}, 100);
  std::vector<float> all(set.size(), kNoValue);
  for (size_t i = 0; i < all.size(); ++i)
  {
    const size_t column = i % kColumns;
    all[i] = column >= from && column < to ? friction : kNoValue;
  }
  set.layers.push_back({"friction", "1", std::move(all)});
  return set;
}

/** Along x in the lowest row of cells, a point every 10 cm, 20 m. */
Path straight()
{
  Path path;
  for (int i = 0; i <= 200; ++i)
  {
    path.push_back({{0.05 + 0.1 * i, 0.05, 0}, 0.1 * i, 0, false});
  }
  return path;
}

/** Half of the friction is used; nothing waits or creeps. */
SpeedParams half()
{
  SpeedParams params;
  params.friction = 0.6;
  params.friction_margin = 0.5;
  params.lateral_accel_mps2 = 1;
  params.reaction_s = 0;
  params.creep_mps = 0.01;
  return params;
}

geometry::Drivetrain fast()
{
  geometry::Drivetrain drivetrain;
  drivetrain.max_speed_mps = 3;
  drivetrain.max_accel_mps2 = 1;
  drivetrain.max_decel_mps2 = 2;
  drivetrain.max_yaw_rate_degps = 720;
  return drivetrain;
}

TEST(Grip, IsTheLeastFrictionThatAnyMapIsSureOf)
{
  CostParams params = withoutBuffers();
  params.grip_price = 4;
  params.good_friction = 0.5;
  params.friction_sigmas = 2;
  layers::LayerSet felt = occupancyOf({".."});
  withLayer(withLayer(felt, "friction", 0.6F), "friction_deviation", 0.125F);
  layers::LayerSet other = occupancyOf({".."});
  other.layers.push_back({"friction", "1", std::vector<float>{0.25F, kNoValue}});
  const Costmap costmap = costsOf({felt, other}, params);
  EXPECT_FLOAT_EQ(costmap.friction[0], 0.25F);
  EXPECT_FLOAT_EQ(costmap.friction[1], 0.35F);
  EXPECT_FLOAT_EQ(costmap.price[0], 1 + 4 * (1 - 0.25F / 0.5F));
  EXPECT_FLOAT_EQ(costmap.price[1], 1 + 4 * (1 - 0.35F / 0.5F));
}

TEST(Grip, CostsNothingWhereItIsGoodOrNotKnown)
{
  layers::LayerSet set = occupancyOf({"...."});
  set.layers.push_back({"friction", "1", std::vector<float>{0.5F, 0.8F, kNoValue, -1.0F}});
  const Costmap costmap = costsOf({set}, withoutBuffers());
  EXPECT_EQ(costmap.price, (std::vector<float>(4, kLeastPrice)));
  EXPECT_TRUE(std::isnan(costmap.friction[2]));
  EXPECT_TRUE(std::isnan(costmap.friction[3]));  // there is no such friction
  EXPECT_TRUE(costsOf({occupancyOf({"."})}, withoutBuffers()).friction.empty());
}

TEST(Grip, IsNeverNothingAtAll)
{
  layers::LayerSet set = occupancyOf({"."});
  withLayer(withLayer(set, "friction", 0.1F), "friction_deviation", 5);
  const Costmap costmap = costsOf({set}, withoutBuffers());
  EXPECT_GT(costmap.friction[0], 0);
  EXPECT_LE(costmap.price[0], 1 + CostParams().grip_price);
}

TEST(Grip, IsAmongTheReadLayersAndExplained)
{
  const layers::LayerChoice read = costLayers();
  EXPECT_TRUE(read.has("friction"));
  EXPECT_TRUE(read.has("friction_deviation"));
  layers::LayerSet set = occupancyOf({"."});
  withLayer(withLayer(set, "friction", 0.3F), "friction_deviation", 0.1F);
  const auto facts = explainCost(
      std::vector<MapLayers>{{"felt", &set}}, costsOf({set}, withoutBuffers()), 0.1, 0.1, {},
      withoutBuffers());
  const auto found = std::find_if(
      facts.begin(), facts.end(), [](const auto& fact) { return fact.key == "felt: friction"; });
  ASSERT_NE(found, facts.end());
  EXPECT_EQ(found->value, "0.1 for sure: price + 3.2");
}

TEST(Grip, SlowsDownBeforeACurveOnIce)
{
  Path path = straight();
  for (size_t i = 100; i < 140; ++i)
  {
    path[i].curvature_1pm = 0.2;
  }
  const auto dry =
      speedProfile(path, costsOf({ground(0.6F, 0, 0)}, withoutBuffers()), fast(), 9, half());
  const auto icy =
      speedProfile(path, costsOf({ground(0.1F, 90, 150)}, withoutBuffers()), fast(), 9, half());
  EXPECT_NEAR(dry[120].speed_mps, std::sqrt(1 / 0.2), kRounding);
  EXPECT_EQ(dry[120].reason, SpeedReason::curve);
  const double most = 0.1 * 0.5 * 9.81;
  EXPECT_NEAR(icy[120].speed_mps, std::sqrt(most / 0.2), kRounding);
  EXPECT_EQ(icy[120].reason, SpeedReason::grip);
  // On the ice before the curve it brakes as little as ice allows; on the dry ground before, more.
  const double at_ice = icy[90].speed_mps;
  EXPECT_NEAR(at_ice * at_ice, most / 0.2 + 2 * most * 1.0, kRounding);
  const double before_ice = icy[85].speed_mps;
  // its last leg ends on the ice
  EXPECT_NEAR(before_ice * before_ice - at_ice * at_ice, 2 * (2 * 0.4 + most * 0.1), kRounding);
}

TEST(Grip, StopsBeforeTheUnknownByTheWorstOnTheWayThere)
{
  const std::string cells = std::string(150, '.') + std::string(60, ' ');
  layers::LayerSet set = ground(0.1F, 100, 110);
  set.layers.front() = occupancyOf({cells, cells, cells}, 100).layers.front();
  const auto limits = speedProfile(straight(), costsOf({set}, withoutBuffers()), fast(), 9, half());
  const auto braked = [&](size_t i, double brake_mps2)
  { return std::sqrt(2 * brake_mps2 * 0.1 * (150 - static_cast<double>(i))); };
  EXPECT_NEAR(limits[130].speed_mps, std::min(3.0, braked(130, 2)), kRounding);
  EXPECT_NEAR(limits[95].speed_mps, braked(95, 0.1 * 0.5 * 9.81), kRounding);
  EXPECT_EQ(limits[95].reason, SpeedReason::unknown);
}

TEST(Grip, AcceleratesNoMoreThanTheGroundTakes)
{
  const auto limits = speedProfile(
      straight(), costsOf({ground(0.1F, 0, 210)}, withoutBuffers()), fast(), 0, half());
  const double most = 0.1 * 0.5 * 9.81;
  EXPECT_NEAR(limits[50].speed_mps, std::sqrt(0.01 * 0.01 + 2 * most * 5), kRounding);
}

TEST(Grip, IsFeltByTheWholeFootprint)
{
  geometry::Vehicle vehicle;
  vehicle.footprint_xs_m = {-0.5, 0.5, 0.5, -0.5};
  vehicle.footprint_ys_m = {-0.1, -0.1, 0.1, 0.1};
  const Costmap costmap = costsOf({ground(0.2F, 50, 60)}, withoutBuffers());
  EXPECT_FLOAT_EQ(frictionUnder(costmap, vehicle, {4.6, 0.15, 0}), 0.2F);
  EXPECT_TRUE(std::isnan(frictionUnder(costmap, vehicle, {4.4, 0.15, 0})));
  EXPECT_TRUE(std::isnan(frictionUnder(costmap, vehicle, {kNoValue, 0, 0})));
}

TEST(Grip, LengthensTheWayThatTheGuardKeeps)
{
  geometry::Vehicle vehicle;
  vehicle.footprint_xs_m = {-0.5, 0.5, 0.5, -0.5};
  vehicle.footprint_ys_m = {-0.3, -0.3, 0.3, 0.3};
  MotionGuard guard(vehicle, fast(), {0.1, 0.1});
  const std::vector<Eigen::Vector3f> ahead = {{1.1F, 0, 0}};  // 0.5 m before front and margin
  const double dry = guard.guarded({1, 0}, {1, 0}, ahead).speed_mps;
  EXPECT_EQ(dry, 1);  // 0.1 m and 0.25 m
  guard.standOn(0.1);
  const double icy = guard.guarded({1, 0}, {1, 0}, ahead).speed_mps;
  const double stops_m = icy * 0.1 + icy * icy / (2 * 0.1 * 9.81);
  EXPECT_LE(stops_m, 0.5 + kRounding);
  EXPECT_GE(stops_m, 0.4);  // steps of 5 cm round down
  guard.standOn(kNoValue);
  EXPECT_EQ(guard.guarded({1, 0}, {1, 0}, ahead).speed_mps, 1);
}
}  // namespace
