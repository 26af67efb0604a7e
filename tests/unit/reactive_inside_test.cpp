// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_ini.h"
#include "places.h"
#include "simulated_clock.h"
#include "support/scratch_folder.h"
#include "watched_navigator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace traverse::reactive
{
namespace
{
using ::testing::HasSubstr;
using ::testing::Not;

/** Senses that fail. */
class Blind : public SensesInterface
{
 public:
  using SensesInterface::SensesInterface;
  bool is_blind = false;

  bool senseObstacles(
      mrpt::maps::CSimplePointsMap& obstacles, mrpt::system::TTimeStamp& time) override
  {
    return !is_blind && SensesInterface::senseObstacles(obstacles, time);
  }
};

ReactiveParams coarse()
{
  ReactiveParams params;
  params.reference_distance_m = 2;
  params.paths = 21;
  params.grid_resolution_m = 0.2;
  return params;
}

TEST(WatchedNavigator, NotesTheEmergencyStopThatMrptForgets)
{
  const traverse::testing::ScratchFolder scratch;
  Blind senses(1);
  const auto made =
      makeNavigator(Navigator::flat, navigatorIni({}, {}, coarse()), scratch.path(), senses);
  auto& navigator = made->mrptNavigator();
  const SimulatedClock clock(1'000'000'000);
  Senses shown;
  shown.now = 1'000'000'000;
  mrpt::nav::TWaypointSequence way;
  way.waypoints.emplace_back(2, 0, 0.1, false);
  navigator.navigateWaypoints(way);
  senses.is_blind = true;
  senses.show(shown);
  navigator.navigationStep();
  // If this fails, MRPT has learnt to keep NAV_ERROR, and events().error is no longer needed.
  EXPECT_EQ(navigator.getCurrentState(), mrpt::nav::CAbstractNavigator::NAVIGATING);
  EXPECT_THAT(senses.events().error, HasSubstr("obstacles"));
  senses.is_blind = false;
  senses.show(shown);
  navigator.navigationStep();
  EXPECT_EQ(senses.events().error, "");
  EXPECT_TRUE(senses.events().twist.has_value());
}

TEST(NavigatorIni, MakesFamiliesThatTheVehicleCanDrive)
{
  geometry::Drivetrain drivetrain;
  const std::string turning = navigatorIni({}, drivetrain, {});
  EXPECT_THAT(turning, HasSubstr("PTG_COUNT = 3"));
  EXPECT_THAT(turning, HasSubstr("PTG1_Type = CPTG_DiffDrive_alpha"));
  EXPECT_THAT(turning, HasSubstr("PTG0_w_max_dps = 60\n"));
  drivetrain.steering = geometry::Steering::ackermann;
  drivetrain.wheelbase_m = 0.5;
  drivetrain.max_steer_deg = 45;  // circles of 0.5 m: 2 rad/s at 1 m/s
  const std::string car = navigatorIni({}, drivetrain, {});
  EXPECT_THAT(car, HasSubstr("PTG_COUNT = 5"));
  EXPECT_THAT(car, Not(HasSubstr("alpha")));
  EXPECT_THAT(car, HasSubstr("robotMax_W_degps = 114.59155"));
}

TEST(NavigatorIni, LeavesOutWhatDrivesBackward)
{
  geometry::Drivetrain drivetrain;
  drivetrain.max_reverse_mps = 0;
  EXPECT_THAT(navigatorIni({}, drivetrain, {}), HasSubstr("PTG_COUNT = 2"));
  drivetrain.steering = geometry::Steering::ackermann;
  const std::string car = navigatorIni({}, drivetrain, {});
  EXPECT_THAT(car, HasSubstr("PTG_COUNT = 2"));
  EXPECT_THAT(car, HasSubstr("PTG1_Type = CPTG_DiffDrive_CS"));
}

TEST(NavigatorIni, CountsFamiliesFromOneForThreeDimensions)
{
  ReactiveParams params;
  params.navigator = Navigator::levels;
  const std::string text = navigatorIni({}, {}, params);
  EXPECT_THAT(text, HasSubstr("[CReactiveNavigationSystem3D]"));
  EXPECT_THAT(text, HasSubstr("LEVEL2_HEIGHT = 1\n"));
  EXPECT_THAT(text, HasSubstr("PTG3_Type = CPTG_DiffDrive_C\n"));
  EXPECT_THAT(text, Not(HasSubstr("PTG0_")));
}

const Places::Limits limits_m{
    .turning_radius = 1, .tolerance = 0.2, .goal_tolerance = 0.1, .near = 1};

TEST(Places, GoesOnFromAPlaceThatIsReached)
{
  Places places({{0.1, 0}, {0.15, 0}, {2, 0}}, limits_m);
  EXPECT_TRUE(places.goOn({0, 0, 0}));
  EXPECT_EQ(places.next(), 2U);
  EXPECT_FALSE(places.goOn({0, 0, 0}));
}

TEST(Places, GoesOnFromAPlaceInsideTheTurningCircle)
{
  Places places({{0.5, 0.5}, {1, 2}}, limits_m);
  EXPECT_TRUE(places.goOn({0, 0, 0}));
  Places before({{0.5, 0.1}, {1, 2}}, limits_m);
  EXPECT_FALSE(before.goOn({0, 0, 0})) << "an arc of 1.3 m leads there";
}

TEST(Places, GoesOnFromAPlaceThatItHasDrivenBy)
{
  const Places::Limits turning{.tolerance = 0.2, .goal_tolerance = 0.1, .near = 1};
  Places places({{1, 0}, {2, 0}, {3, 0}}, turning);
  EXPECT_FALSE(places.goOn({0.9, 0.6, 0}));
  EXPECT_TRUE(places.goOn({1.1, 0.6, 0}));
  EXPECT_EQ(places.next(), 1U);
  Places hairpin({{0, 0}, {2, 0}, {2, 0.5}, {0, 0.5}}, turning);
  EXPECT_TRUE(hairpin.goOn({0.1, 0, 0}));
  EXPECT_FALSE(hairpin.goOn({1.5, 0, 0}));
  EXPECT_EQ(hairpin.next(), 1U) << "it has not come to the bend";
}

TEST(Places, IsOverAtTheLastPlaceOnly)
{
  Places round({{0, 0}, {2, 0}, {0, 0}}, limits_m);
  EXPECT_TRUE(round.goOn({0, 0, 0}));
  EXPECT_FALSE(round.isOver({0, 0, 0})) << "it has not been round";
  EXPECT_TRUE(round.goOn({1.9, 0, 0}));
  EXPECT_TRUE(round.isOver({0.05, 0, 0}));
  EXPECT_FALSE(round.isOver({0.15, 0, 0}));
}
}  // namespace
}  // namespace traverse::reactive
