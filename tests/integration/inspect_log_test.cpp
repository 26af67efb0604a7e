// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-inspect on logs.
#include "support/data.h"
#include "support/scratch_folder.h"
#include "support/synthetic_logs.h"
#include "support/traverse_inspect.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace
{
using namespace traverse::testing;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string kLaser = mrptData("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");

TEST(InspectLog, TellsWhatIsInIt)
{
  const Finished ran = traverseInspect({kLaser});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(
      ran.out, AllOf(
                   HasSubstr("449 entries, complete"), HasSubstr("CObservation2DRangeScan: 225"),
                   HasSubstr("at 0.780 0.000 0.300 m"), HasSubstr("CActionRobotMovement2D"),
                   HasSubstr("225 scans")));
}

TEST(InspectLog, AnswersAsJson)
{
  const Finished ran = traverseInspect({kLaser, "--json", "--quiet"});
  const json answer = json::parse(ran.out);
  EXPECT_EQ(answer["end"], "complete");
  EXPECT_EQ(answer["scans"][0]["scans"], 225);
  EXPECT_GT(answer["sensors"][0]["rate_hz"], 3);  // 225 scans in 59 s
  EXPECT_LT(answer["sensors"][0]["rate_hz"], 5);
  EXPECT_THAT(ran.err, IsEmpty());
}

TEST(InspectLog, DrawsTheFirstCloudOfEachSensor)
{
  const ScratchFolder scratch;
  const Finished ran =
      traverseInspect({mrptData("test_velodyne_VLP16.rawlog"), "--pictures", scratch / "pictures"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* name : {"Velodyne1_SCAN_top.png", "Velodyne1_SCAN_3d.png"})
  {
    EXPECT_THAT(ran.out, HasSubstr(name));
    EXPECT_THAT(readText(scratch / "pictures" / name), HasSubstr("PNG"));
  }
  EXPECT_THAT(ran.out, HasSubstr("rings, a time per point, intensity"));
}

TEST(InspectLog, ShowsWhatCameBeforeADamage)
{
  const ScratchFolder scratch;
  const std::string log = laserLog(10);
  writeText(scratch / "cut.rawlog", log.substr(0, log.size() * 3 / 4));
  const Finished ran = traverseInspect({scratch / "cut.rawlog"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_THAT(ran.out, HasSubstr("damaged"));
  EXPECT_THAT(ran.err, HasSubstr("cut.rawlog"));
}

TEST(InspectLog, LabelsCannotSpeakToTheTerminal)
{
  const ScratchFolder scratch;
  auto scan = laserScan(0);
  scan.sensorLabel = "\x1b[31mred\n";
  writeText(scratch / "hostile.rawlog", serialised(scan));
  const Finished ran = traverseInspect({scratch / "hostile.rawlog", "--pictures", scratch / "p"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_THAT(ran.out, AllOf(HasSubstr("?[31mred?"), Not(HasSubstr("\x1b"))));
}

TEST(InspectLog, SaysWhatItCannotRead)
{
  const ScratchFolder scratch;
  writeText(scratch / "text.rawlog", "this is no log, this is prose and nothing but prose");
  EXPECT_EQ(traverseInspect({scratch / "text.rawlog"}).exit_code, 4);
  EXPECT_EQ(traverseInspect({scratch / "missing.rawlog"}).exit_code, 4);
  EXPECT_EQ(traverseInspect({}).exit_code, 2);
  EXPECT_EQ(traverseInspect({kLaser, "--doctor", "--diff", "a", "b"}).exit_code, 2);
  EXPECT_EQ(traverseInspect({"--help"}).exit_code, 0);
}
}  // namespace
