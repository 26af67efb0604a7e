// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/decimal.h>
#include <traverse/formats/safe_file.h>
#include <traverse/formats/trajectory.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <random>
#include <support/data.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using traverse::poses::StampedPose;

std::string errorOf(const std::string& rows, const std::string& times = "")
{
  try
  {
    parseTrajectory({rows, "p.txt"}, {times, times.empty() ? "" : "t.txt"});
  }
  catch (const FormatError& e)
  {
    return e.what();
  }
  return "";
}

const std::string tum_row = "1305031102.175304 1 2 3 0 0 0.5 0.8660254037844386\n";
const std::string kitti_row = "1 0 0 10 0 1 0 20 0 0 1 30\n";

TEST(ParseSecondsAsNs, IsExactToTheNanosecond)
{
  EXPECT_EQ(parseSecondsAsNs("1305031102.175304"), 1305031102175304000);
  EXPECT_EQ(parseSecondsAsNs("1700000000.123456789"), 1700000000123456789)
      << "a double would be off by up to 119 ns here";
  EXPECT_EQ(parseSecondsAsNs("1.036224e-01"), 103622400);
  EXPECT_EQ(parseSecondsAsNs("1.7e+09"), 1700000000000000000);
  EXPECT_EQ(parseSecondsAsNs("-0.5"), -500000000);
  EXPECT_EQ(parseSecondsAsNs("+3."), 3000000000);
  EXPECT_EQ(parseSecondsAsNs(".25"), 250000000);
  EXPECT_EQ(parseSecondsAsNs("0.0000000005"), 1) << "halves away from zero";
  EXPECT_EQ(parseSecondsAsNs("0.00000000049"), 0);
  EXPECT_EQ(parseSecondsAsNs("1e-30000"), 0);
  EXPECT_EQ(parseSecondsAsNs("9223372036.854775806"), 9223372036854775806);
}

TEST(ParseSecondsAsNs, RefusesWhatIsNoTime)
{
  for (const char* text :
       {"", "-", ".", "1,5", "abc", "1.2.3", "nan", "inf", "0x10", "1e", "1e+-3", "--1", "+-1",
        "9223372037", "1e30", "1e99999", "1 "})
  {
    EXPECT_FALSE(parseSecondsAsNs(text)) << text;
  }
}

TEST(ParseNumber, TakesFiniteNumbersOnly)
{
  EXPECT_EQ(parseNumber("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(parseNumber("+2"), 2);
  for (const char* text : {"", "+", "+-1", "1,5", "nan", "inf", "-inf", "1e999", "0x1p3", "2 "})
  {
    EXPECT_FALSE(parseNumber(text)) << text;
  }
}

TEST(Trajectory, ReadsTum)
{
  const auto poses =
      parseTrajectory({"# comment\r\n\n\t" + tum_row + "5 0 0 0 0 0 0 1 # end", "p"});
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].time, 1305031102175304000);
  EXPECT_EQ(poses[0].T_map_base.translation(), Eigen::Vector3d(1, 2, 3));
  const Eigen::AngleAxisd turn(poses[0].T_map_base.linear());
  EXPECT_NEAR(turn.angle() * turn.axis().z(), M_PI / 3, 1e-12) << "2 asin(0.5) about z";
  EXPECT_EQ(poses[1].time, 5000000000);
}

TEST(Trajectory, ReadsKittiWithItsTimes)
{
  const auto poses = parseTrajectory(
      {kitti_row + "0 -1 0 1 1 0 0 2 0 0 1 3\n", "p"}, {"0.000000e+00\n1.036224e-01\n", "t"});
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].T_map_base.translation(), Eigen::Vector3d(10, 20, 30));
  EXPECT_EQ(poses[1].time, 103622400);
  EXPECT_TRUE((poses[1].T_map_base.linear() * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d::UnitY(), 1e-12))
      << "rows of the matrix are rows of the file";
}

TEST(Trajectory, FrameNumbersPickTheirTimes)
{
  const auto poses =
      parseTrajectory({"2 " + kitti_row + "0 " + kitti_row, "p"}, {"5\n6\n7\n8\n", "t"});
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].time, 7000000000);
  EXPECT_EQ(poses[1].time, 5000000000);
}

TEST(Trajectory, ErrorsNameFileAndLine)
{
  EXPECT_EQ(errorOf("# x\n1 2 3\n"), "p.txt:2: 3 columns: TUM has 8, KITTI 12 or 13");
  EXPECT_EQ(errorOf(tum_row + "1 2 3\n"), "p.txt:2: 3 columns, the rows before have 8");
  EXPECT_EQ(errorOf("1 2 x3 3 0 0 0 1"), "p.txt:1: 'x3' is no finite number");
  EXPECT_EQ(errorOf("1 2 nan 3 0 0 0 1"), "p.txt:1: 'nan' is no finite number");
  EXPECT_EQ(errorOf("t 1 2 3 0 0 0 1"), "p.txt:1: 't' is no time in seconds");
  EXPECT_EQ(errorOf("1 1 2 3 0 0 0 2"), "p.txt:1: the quaternion has length 2, not 1");
  EXPECT_EQ(errorOf("1 1e9 2 3 0 0 0 1"), "p.txt:1: the position is beyond 1e8 m");
  EXPECT_EQ(errorOf("# nothing\n"), "p.txt: no pose in it");
  EXPECT_EQ(errorOf(kitti_row), "p.txt:1: KITTI rows need a file of times");
  EXPECT_EQ(errorOf(kitti_row, "1 2\n"), "t.txt:1: 2 words, a time is one");
  EXPECT_EQ(errorOf(kitti_row, "1\n2\n"), "p.txt has 1 rows, but t.txt has 2 times");
  EXPECT_EQ(
      errorOf(kitti_row + kitti_row, "1\n"),
      "p.txt:2: no time for row or frame 1: t.txt has 1 times");
  EXPECT_EQ(
      errorOf("2 0 0 10 0 2 0 20 0 0 2 30", "1\n"),
      "p.txt:1: the first three columns of the 3x4 matrix are no rotation");
  EXPECT_EQ(
      errorOf("1 0 0 0 0 1 0 0 0 0 -1 0", "1\n"),
      "p.txt:1: the first three columns of the 3x4 matrix are no rotation")
      << "a mirror";
  EXPECT_EQ(errorOf("-1 " + kitti_row, "1\n"), "p.txt:1: '-1' is no frame number");
}

TEST(Trajectory, TumComesBackAsItWas)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<StampedPose> poses;
  for (int i = 0; i < 200; ++i)
  {
    StampedPose p;
    p.time = (i % 2 == 0 ? -1 : 1) * (1700000000123456789 + i);
    p.T_map_base.linear() = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    p.T_map_base.translation() =
        Eigen::Vector3d(number(random), number(random), number(random)) * 1e7;
    poses.push_back(p);
  }
  const auto back = parseTrajectory({tumTrajectory(poses), "p"});
  ASSERT_EQ(back.size(), poses.size());
  for (size_t i = 0; i < poses.size(); ++i)
  {
    EXPECT_EQ(back[i].time, poses[i].time);
    EXPECT_EQ(back[i].T_map_base.translation(), poses[i].T_map_base.translation());
    // To a quaternion and back: some roundings of 1e-16.
    EXPECT_TRUE(back[i].T_map_base.linear().isApprox(poses[i].T_map_base.linear(), 1e-14));
  }
}

TEST(Trajectory, ACommaLocaleChangesNothing)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const bool comma = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const auto poses = parseTrajectory({"0.5 0.5 0 0 0 0 0 1", "p"});
  const std::string text = tumTrajectory(poses);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(poses[0].time, 500000000);
  EXPECT_EQ(poses[0].T_map_base.translation().x(), 0.5);
  EXPECT_THAT(text, ::testing::HasSubstr("0.500000000 0.5 0 0 "));
  if (!comma)
  {
    GTEST_SKIP() << "SKIPPED: no de_DE locale is installed here";
  }
}

TEST(Trajectory, RandomBytesNeverCrashTheReader)
{
  std::mt19937 random(11);
  const std::string alphabet = std::string("0123456789.eE+- \n\t#x\xff") + '\0';
  for (int i = 0; i < 20000; ++i)
  {
    std::string text = i % 2 == 0 ? tum_row + tum_row : kitti_row;
    for (int n = 0; n < 1 + i % 7; ++n)
    {
      text[random() % text.size()] = alphabet[random() % alphabet.size()];
    }
    errorOf(text, "1\n");
  }
}

TEST(Trajectory, ReadsRealKittiPosesWithFrameNumbers)
{
  const auto path = sharedData("kitti-odo00-labelled/poses_velodyne_world.txt");
  TRAVERSE_NEEDS(path);
  const ScratchFolder folder;
  std::string times;
  for (int i = 0; i < 5000; ++i)
  {
    times += std::to_string(i / 10) + "." + std::to_string(i % 10) + "\n";
  }
  writeFile(folder.path() / "times.txt", times);
  const auto poses = readTrajectory(path, folder.path() / "times.txt");
  ASSERT_GT(poses.size(), 2U);
  EXPECT_EQ(poses[1].time, 100000000);
  EXPECT_NEAR(poses[1].T_map_base.translation().x(), 0.8587678403, 1e-12);
}
}  // namespace
