// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/disc_course.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

namespace traverse::testing
{
namespace
{
using geometry::Steering;
using reactive::Navigator;
using reactive::Outcome;

geometry::Vehicle smallVehicle()
{
  geometry::Vehicle vehicle;
  vehicle.footprint_xs_m = {-0.2, 0.5, 0.5, -0.2};
  vehicle.footprint_ys_m = {-0.25, -0.25, 0.25, 0.25};
  vehicle.height_m = 1;
  return vehicle;
}

/** Coarse, so that its collision grids are made in a second. */
reactive::ReactiveParams coarse(Navigator navigator)
{
  reactive::ReactiveParams params;
  params.navigator = navigator;
  params.reference_distance_m = 4;
  params.paths = 61;
  params.grid_resolution_m = 0.1;
  return params;
}

/** 16 m in bends, a place each metre. */
std::vector<Eigen::Vector2d> bends()
{
  std::vector<Eigen::Vector2d> places;
  for (int n = 1; n <= 16; ++n)
  {
    places.emplace_back(n, 2 * std::sin(n * 0.4));
  }
  return places;
}

struct Kind
{
  Steering steering;
  Navigator navigator;
};

std::string nameOf(const ::testing::TestParamInfo<Kind>& info)
{
  return options::format(info.param.steering) + "_" + options::format(info.param.navigator);
}

class ReactiveDrive : public ::testing::TestWithParam<Kind>
{
};

TEST_P(ReactiveDrive, PassesDiscsOnItsWayToTheGoalWithoutTouchingThem)
{
  const ScratchFolder scratch;
  const geometry::Vehicle vehicle = smallVehicle();
  geometry::Drivetrain drivetrain;
  drivetrain.steering = GetParam().steering;
  reactive::ReactiveDriver driver(
      vehicle, drivetrain, coarse(GetParam().navigator), scratch.path());
  // As a plan does: from its places to the next rim 55 cm or more, also where it starts.
  std::vector<Eigen::Vector2d> free = bends();
  free.emplace_back(0, 0);
  free.emplace_back(0.5, 0.1);
  for (const uint32_t seed : {1U, 2U, 3U, 4U})
  {
    SCOPED_TRACE(seed);
    const std::vector<Disc> discs = randomDiscs(seed, 200, 1.1, free);
    ASSERT_GT(discs.size(), 15U);
    const Drive drive = driveAmong(discs, bends(), driver, vehicle, 60);
    EXPECT_EQ(drive.outcome, Outcome::arrived) << drive.text;
    // Rim points stand 10 cm apart and grid cells are 10 cm: both are on the safe side of a touch.
    EXPECT_GT(drive.least_clearance_m, 0);
    const Eigen::Vector2d end(drive.end.x_m, drive.end.y_m);
    EXPECT_LT((end - bends().back()).norm(), 0.3 + 0.05) << "goal tolerance and one step";
    if (drivetrain.steering == Steering::ackermann)
    {
      EXPECT_LE(drive.tightest_1pm, 1 / minTurningRadius_m(drivetrain) + 1e-9);
    }
    RecordProperty(
        "median_step_us", static_cast<int>(drive.step_ms[drive.step_ms.size() / 2] * 1e3));
  }
}

TEST_P(ReactiveDrive, DrivesRoundWhatStandsOnAPlaceOfThePlan)
{
  const ScratchFolder scratch;
  const geometry::Vehicle vehicle = smallVehicle();
  geometry::Drivetrain drivetrain;
  drivetrain.steering = GetParam().steering;
  reactive::ReactiveDriver driver(
      vehicle, drivetrain, coarse(GetParam().navigator), scratch.path());
  for (const double radius_m : {0.1, 0.25, 0.6})
  {
    SCOPED_TRACE(radius_m);
    const std::vector<Disc> discs = {{bends()[7], radius_m}};
    const Drive drive = driveAmong(discs, bends(), driver, vehicle, 60);
    EXPECT_EQ(drive.outcome, Outcome::arrived) << drive.text;
    EXPECT_GT(drive.least_clearance_m, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds,
    ReactiveDrive,
    ::testing::Values(
        Kind{Steering::differential, Navigator::flat},
        Kind{Steering::differential, Navigator::levels},
        Kind{Steering::ackermann, Navigator::flat},
        Kind{Steering::ackermann, Navigator::levels}),
    nameOf);
}  // namespace
}  // namespace traverse::testing
