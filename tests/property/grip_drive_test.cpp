// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/speed_profile.h>
#include <traverse/simulation/vehicle_model.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <support/cost_pictures.h>
#include <support/simple_scene.h>

// Profiles driven by the simulated vehicle, which slips where it is asked for more than mu g.
namespace
{
using namespace traverse;
using namespace traverse::navigation;
using namespace traverse::testing;
using simulation::Material;

constexpr double kStep_s = 0.01;
constexpr double kWay_m = 20;

geometry::Drivetrain robot()
{
  geometry::Drivetrain drivetrain;
  drivetrain.max_speed_mps = 3;
  drivetrain.max_accel_mps2 = 0.9;
  drivetrain.max_decel_mps2 = 2;
  drivetrain.max_yaw_rate_degps = 90;
  drivetrain.max_yaw_accel_degps2 = 30;  // that it turns at all takes grip, too
  return drivetrain;
}

/** kWay_m from the origin along an arc to the left. */
Path arc(double curvature_1pm)
{
  Path path;
  for (int i = 0; i <= 10 * kWay_m; ++i)
  {
    const double along_m = 0.1 * i;
    const double turn = along_m * curvature_1pm;
    const geometry::Pose2 pose =
        curvature_1pm == 0
            ? geometry::Pose2{along_m, 0, 0}
            : geometry::Pose2{
                  std::sin(turn) / curvature_1pm, (1 - std::cos(turn)) / curvature_1pm, turn};
    path.push_back({pose, along_m, curvature_1pm, false});
  }
  return path;
}

/** Free ground around the paths; its friction, where it is told. */
Costmap around(bool tells_friction, Material material)
{
  layers::LayerSet set = occupancyOf(CostPicture(250, std::string(250, '.')));
  set.extent = {{-100, -100}, {150, 150}};
  if (tells_friction)
  {
    withLayer(set, "friction", static_cast<float>(simulation::frictionOf(material)));
  }
  return costsOf({set}, withoutBuffers());
}

struct Driven
{
  double way_m = 0;
  double last_mps = 0;
  int slips = 0;  // steps
  int steps = 0;  // until it stood
};

/** At a place between two points of a path, evenly accelerated from one to the other. */
double speedAt(double along_m, const Path& path, const std::vector<SpeedLimit>& limits)
{
  const auto last = static_cast<double>(path.size() - 1);
  const double place = std::clamp(along_m * 10, 0.0, last);
  const auto i = static_cast<size_t>(std::min(place, last - 1));
  const double share = place - static_cast<double>(i);
  const double from = limits[i].speed_mps;
  const double to = limits[i + 1].speed_mps;
  return std::sqrt((1 - share) * from * from + share * to * to);
}

/** Speeds of the path's profile at the way driven so far, turned by its curvature. */
Driven drive(Material material, double curvature_1pm, bool tells_friction)
{
  const Path path = arc(curvature_1pm);
  const auto limits =
      speedProfile(path, around(tells_friction, material), robot(), 0, SpeedParams());
  simulation::VehicleModel vehicle(
      std::make_shared<Floor>(material), geometry::Vehicle(), robot(), {});
  Driven driven;
  for (int k = 0; k < 6000 && driven.way_m < 3 * kWay_m; ++k)
  {
    const double speed = speedAt(driven.way_m, path, limits);
    vehicle.step({speed, speed * curvature_1pm}, kStep_s);
    driven.last_mps = vehicle.state().twist.speed_mps;
    driven.way_m += driven.last_mps * kStep_s;
    driven.slips += vehicle.state().slips ? 1 : 0;
    driven.steps += driven.last_mps != 0 ? 1 : 0;
  }
  return driven;
}

TEST(GripDrive, StopsOnIceWhereItMeantToIfAMapKnowsTheIce)
{
  const Driven told = drive(Material::ice, 0, true);
  EXPECT_EQ(told.slips, 0);
  EXPECT_EQ(told.last_mps, 0);
  EXPECT_NEAR(told.way_m, kWay_m, 0.3);
  const Driven blind = drive(Material::ice, 0, false);
  EXPECT_GT(blind.slips, 10);
  EXPECT_GT(blind.way_m, kWay_m + 1);
}

TEST(GripDrive, TakesCurvesOnIceWithoutSlipping)
{
  EXPECT_EQ(drive(Material::ice, 0.3, true).slips, 0);
  EXPECT_GT(drive(Material::ice, 0.3, false).slips, 10);
}

TEST(GripDrive, IsNoSlowerWhereGripIsGood)
{
  const Driven told = drive(Material::asphalt, 0, true);
  const Driven blind = drive(Material::asphalt, 0, false);
  EXPECT_EQ(told.slips, 0);
  EXPECT_EQ(told.way_m, blind.way_m);
  EXPECT_EQ(told.steps, blind.steps);
}
}  // namespace
