// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-map --point-labels: a file for each cloud, a label for each of its points.
#include "support/scratch_folder.h"
#include "support/synthetic_logs.h"
#include "support/traverse_map.h"

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace
{
using namespace traverse::testing;
using ::testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/** Level ground, a point of nothing, a box, a branch, and a point that the ini cuts out. */
mrpt::obs::CObservationPointCloud cloud(double t_s)
{
  mrpt::obs::CObservationPointCloud observation;
  observation.timestamp = mrpt::Clock::fromDouble(1.6e9 + t_s);
  observation.sensorLabel = "lidar";
  observation.sensorPose = mrpt::poses::CPose3D(0, 0, 1.5, 0, 0, 0);
  auto points = mrpt::maps::CSimplePointsMap::Create();
  for (int i = 0; i < 100; ++i)
  {
    for (int j = 0; j < 100; ++j)
    {
      points->insertPointFast(
          0.05F * static_cast<float>(i) + 1, 0.05F * static_cast<float>(j) - 2.5F, -1.5F);
    }
  }
  points->insertPointFast(kNan, 0, 0);
  points->insertPointFast(3, 0, -0.5F);
  points->insertPointFast(4, 0, 1.2F);
  points->insertPointFast(-0.2F, 0, -1.0F);
  points->insertPointFast(2, 0, -1.5F);
  observation.pointcloud = points;
  return observation;
}

class PointLabels : public ::testing::Test
{
 protected:
  PointLabels()
  {
    writeText(
        folder_ / "clouds.ini",
        "[Poses]\nsource = identity\n[Sensors]\n"
        "own_body_min_m = -1 -1 -1\nown_body_max_m = 0.5 1 2\n[Maps]\n"
        "CTraversabilityGridMap_count = 1\n");
    writeText(folder_ / "log.rawlog", gzipped(serialised(cloud(0)) + serialised(cloud(0.1))));
  }

  Finished label(std::vector<std::string> more = {})
  {
    std::vector<std::string> arguments = {
        folder_ / "clouds.ini", "--rawlog",        folder_ / "log.rawlog",        "--output",
        folder_ / "out",        "--set",           "traverse-map.pictures=false", "--quiet",
        "--point-labels",       folder_ / "labels"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return traverseMap(arguments);
  }

  std::vector<uint32_t> labelsOf(const std::string& name) const
  {
    const std::string bytes = readText(folder_ / "labels" / name);
    std::vector<uint32_t> labels(bytes.size() / sizeof(uint32_t));
    std::memcpy(labels.data(), bytes.data(), labels.size() * sizeof(uint32_t));
    return labels;
  }

  ScratchFolder folder_;
};

TEST_F(PointLabels, AreInTheOrderOfTheInputCloudWhateverWasLeftOut)
{
  const Finished ran = label();
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* name : {"000000.label", "000001.label"})
  {
    const std::vector<uint32_t> labels = labelsOf(name);
    ASSERT_EQ(labels.size(), 10005U) << name;
    EXPECT_EQ(labels[0], 1U);
    EXPECT_EQ(labels[9999], 1U);
    EXPECT_EQ(labels[10000], 0U) << "no number";
    EXPECT_EQ(labels[10001], 2U) << "1 m over the ground";
    EXPECT_EQ(labels[10002], 3U) << "above the vehicle";
    EXPECT_EQ(labels[10003], 0U) << "cut out by [Sensors]";
    EXPECT_EQ(labels[10004], 1U);
  }
}

TEST_F(PointLabels, DoNotMixWithWhatIsThere)
{
  ASSERT_EQ(label().exit_code, 0);
  const Finished again = label({"--set", "traverse-map.output=other"});
  EXPECT_NE(again.exit_code, 0);
  EXPECT_THAT(again.err, HasSubstr("--force"));
  EXPECT_EQ(label({"--force"}).exit_code, 0);
}

TEST_F(PointLabels, AreNotWrittenOverFilesOfOthers)
{
  std::filesystem::create_directories(folder_ / "labels");
  writeText(folder_ / "labels" / "000123.label", "mine");
  EXPECT_EQ(label({"--force"}).exit_code, 1);
  EXPECT_EQ(readText(folder_ / "labels" / "000123.label"), "mine");
}

TEST_F(PointLabels, StayWhereTheLogCannotBeRead)
{
  ASSERT_EQ(label().exit_code, 0);
  const std::string before = readText(folder_ / "labels" / "000001.label");
  writeText(folder_ / "log.rawlog", "no log");
  EXPECT_EQ(label({"--force"}).exit_code, 4);
  EXPECT_EQ(readText(folder_ / "labels" / "000001.label"), before);
}

TEST_F(PointLabels, DoNotLieInTheOutputFolder)
{
  const Finished ran = traverseMap(
      {folder_ / "clouds.ini", "--rawlog", folder_ / "log.rawlog", "--output", folder_ / "out",
       "--point-labels", folder_ / "out" / "labels"});
  EXPECT_EQ(ran.exit_code, 3);
  EXPECT_THAT(ran.err, HasSubstr("beside the output folder"));
}

TEST_F(PointLabels, AreNotForPieces)
{
  EXPECT_EQ(label({"--piece", "1/2"}).exit_code, 2);
}
}  // namespace
