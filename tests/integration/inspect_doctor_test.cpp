// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-inspect --doctor: finds what is wrong with a drive, and nothing where nothing is.
#include "support/cloud_drive.h"
#include "support/scratch_folder.h"
#include "support/traverse_inspect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

namespace
{
using namespace traverse::testing;
using nlohmann::json;
using ::testing::HasSubstr;

/** The doctor's hints at a log. */
json hintsAt(const std::string& log, const std::vector<std::string>& more = {})
{
  const ScratchFolder scratch;
  writeText(scratch / "drive.rawlog", log);
  std::vector<std::string> arguments = {"--doctor", scratch / "drive.rawlog", "--json", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Finished ran = traverseInspect(arguments);
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const json answer = json::parse(ran.out, nullptr, false);
  return answer.is_object() ? answer["hints"] : json::array();
}

json suspicions(const json& hints)
{
  json some = json::array();
  for (const json& hint : hints)
  {
    if (hint["weight"] == "suspicion")
    {
      some.push_back(hint);
    }
  }
  return some;
}

std::optional<json> find(const json& hints, const std::string& key, const std::string& about)
{
  for (const json& hint : hints)
  {
    if (hint["key"] == key && hint["about"] == about)
    {
      return hint;
    }
  }
  return std::nullopt;
}

TEST(Doctor, SuspectsNothingWhereNothingIsWrong)
{
  const json hints = hintsAt(cloudDrive({.second_sensor = true}));
  EXPECT_TRUE(suspicions(hints).empty()) << suspicions(hints);
  const auto ground = find(hints, "ground", "front");
  ASSERT_TRUE(ground);
  EXPECT_NEAR((*ground)["values"]["sensor_m"], 1.8, 0.02);
  EXPECT_NEAR((*ground)["values"]["base_height_m"], 0, 0.02);
  EXPECT_TRUE(find(hints, "heading", "second"));
}

TEST(Doctor, FindsATiltedMount)
{
  const auto lean = find(suspicions(hintsAt(cloudDrive({.pitch_deg = 2}))), "ground_lean", "front");
  ASSERT_TRUE(lean);
  EXPECT_NEAR((*lean)["values"]["pitch_deg"], 2, 0.3);
  EXPECT_THAT((*lean)["text"], HasSubstr("ground ahead lies lower"));
}

TEST(Doctor, FindsPosesThatLag)
{
  const auto lag =
      find(suspicions(hintsAt(cloudDrive({.poses_late_s = 0.1}))), "pose_lag", "poses");
  ASSERT_TRUE(lag);
  EXPECT_NEAR((*lag)["values"]["offset_s"], 0.1, 0.02);
  EXPECT_THAT((*lag)["text"], HasSubstr("the poses lag"));
}

TEST(Doctor, FindsTheOneSensorWhoseClockIsOff)
{
  const json found = suspicions(hintsAt(cloudDrive({.scans_late_s = 0.15, .second_sensor = true})));
  const auto clock = find(found, "clock_offset", "second");
  ASSERT_TRUE(clock) << found;
  EXPECT_NEAR((*clock)["values"]["offset_s"], -0.15, 0.02);
  EXPECT_FALSE(find(found, "clock_offset", "front"));
  EXPECT_FALSE(find(found, "pose_lag", "poses"));
}

TEST(Doctor, FindsSwappedAxes)
{
  const auto axes = find(suspicions(hintsAt(cloudDrive({.camera_axes = true}))), "axes", "front");
  ASSERT_TRUE(axes);
  EXPECT_THAT((*axes)["text"], HasSubstr("up is its -y axis"));
}

TEST(Doctor, FindsWrongUnits)
{
  EXPECT_TRUE(find(suspicions(hintsAt(cloudDrive({.scale = 1000}))), "units", "front"));
}

TEST(Doctor, FindsSensorPosesThatDoNotFit)
{
  const json found =
      suspicions(hintsAt(cloudDrive({.yaw_deg = 3, .second_sensor = true, .second_lower_m = 0.3})));
  const auto heading = find(found, "heading", "front");
  ASSERT_TRUE(heading) << found;
  EXPECT_NEAR((*heading)["values"]["turn_deg"], 3, 0.6);
  const auto height = find(found, "sensor_pose", "second");
  ASSERT_TRUE(height) << found;
  EXPECT_NEAR((*height)["values"]["apart_m"], 0.3, 0.03);
}

TEST(Doctor, FindsStampsInDisorder)
{
  const std::string log = serialised(laserScan(2, 5)) + serialised(laserScan(1, 6)) +
                          serialised(laserScan(1, 7)) + laserLog(5);
  const json found = suspicions(hintsAt(log));
  EXPECT_TRUE(find(found, "backward_stamps", "LASER"));
  EXPECT_TRUE(find(found, "repeated_stamps", "LASER"));
  EXPECT_TRUE(find(hintsAt(log), "poses", "log"));  // there are none, and it says so
}

TEST(Doctor, LooksAtNoMoreSensorsThanAnyRobotHas)
{
  std::string log;
  for (int i = 0; i < 300; ++i)
  {
    auto scan = laserScan(0.1 * i);
    scan.sensorLabel = "L" + std::to_string(i);
    mrpt::obs::CObservationRobotPose pose;
    pose.timestamp = scan.timestamp;
    log += serialised(pose) + serialised(scan);
  }
  size_t sensors = 0;
  for (const json& hint : hintsAt(log))
  {
    sensors += hint["key"] == "drive" ? 1 : 0;
  }
  EXPECT_EQ(sensors, 256U);
}

TEST(Doctor, RefusesAPoseFileThatIsNone)
{
  const ScratchFolder scratch;
  writeText(scratch / "drive.rawlog", laserLog(3));
  const Finished ran =
      traverseInspect({"--doctor", scratch / "drive.rawlog", "--poses", scratch / "missing.tum"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_THAT(ran.err, HasSubstr("missing.tum"));
}
}  // namespace
