// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/to_scan.h>

#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/scratch_folder.h>

namespace
{
using namespace traverse;
using observations::Outcome;
using ::testing::HasSubstr;
using Format = mrpt::obs::CObservationPointCloud::ExternalStorageFormat;

/** A log's image folder with a cloud of two points, and the same file outside of it. */
class ExternalFiles : public ::testing::Test
{
 protected:
  ExternalFiles() : folder_(dir_ / "log_Images")
  {
    std::filesystem::create_directories(folder_ / "deeper");
    for (const auto& file :
         {folder_ / "cloud.txt", folder_ / "deeper" / "cloud.txt",
          std::filesystem::path(dir_ / "cloud.txt")})
    {
      traverse::testing::writeText(file, "1 2 3\n4 5 6\n");
    }
  }

  observations::ScanResult read(const std::string& name)
  {
    cloud_ = mrpt::obs::CObservationPointCloud();
    cloud_.setAsExternalStorage(name, Format::PlainTextFile);
    return observations::toScan(cloud_, {}, folder_);
  }

  traverse::testing::ScratchFolder dir_;
  std::filesystem::path folder_;
  mrpt::obs::CObservationPointCloud cloud_;
};

TEST_F(ExternalFiles, AreReadFromTheLogsOwnFolderAndReleased)
{
  const auto result = read("cloud.txt");
  ASSERT_EQ(result.outcome, Outcome::scan) << result.reason;
  EXPECT_EQ(result.decoded.scan.size(), 2U);
  EXPECT_FALSE(cloud_.pointcloud) << "released";
  EXPECT_EQ(read("deeper/cloud.txt").decoded.scan.size(), 2U);
}

TEST_F(ExternalFiles, AreNeverWritten)
{
  // MRPT's own unload() writes the cloud under the log's name into the working folder.
  const traverse::testing::ScratchFolder elsewhere;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(elsewhere.path());
  EXPECT_EQ(read("cloud.txt").outcome, Outcome::scan);
  std::filesystem::current_path(before);
  EXPECT_TRUE(std::filesystem::is_empty(elsewhere.path()));
}

TEST_F(ExternalFiles, AreNotReadFromElsewhere)
{
  std::filesystem::create_symlink(dir_ / "cloud.txt", folder_ / "link.txt");
  std::filesystem::create_directory_symlink(dir_.path(), folder_ / "up");
  for (const std::string& name :
       {(dir_ / "cloud.txt").string(), std::string("../cloud.txt"),
        std::string("deeper/../cloud.txt"), std::string("link.txt"), std::string("up/cloud.txt"),
        std::string("C:cloud.txt"), std::string("..\\cloud.txt"), std::string("cloud.txt\0x", 11),
        std::string("")})
  {
    const auto result = read(name);
    EXPECT_EQ(result.outcome, Outcome::rejected) << name;
    EXPECT_THAT(result.reason, HasSubstr("outside")) << name;
  }
}

TEST_F(ExternalFiles, ThatAreMissingOrNoFilesAreRefused)
{
  EXPECT_THAT(read("none.txt").reason, HasSubstr("missing"));
  EXPECT_EQ(read("deeper").outcome, Outcome::rejected);
  folder_ = dir_ / "no_such_folder";
  EXPECT_THAT(read("cloud.txt").reason, HasSubstr("folder"));
}

TEST_F(ExternalFiles, OfADepthImageAreCheckedBeforeAnyIsOpened)
{
  mrpt::obs::CObservation3DRangeScan scan;
  scan.hasRangeImage = true;
  scan.rangeImage_setSize(4, 6);
  scan.cameraParams.nrows = 4;
  scan.cameraParams.ncols = 6;
  scan.cameraParams.setIntrinsicParamsFromValues(5, 5, 3, 2);
  scan.hasIntensityImage = true;
  scan.intensityImage.setExternalStorage("/etc/passwd");
  const auto result = observations::toScan(scan, {}, folder_);
  EXPECT_EQ(result.outcome, Outcome::rejected);
  EXPECT_THAT(result.reason, HasSubstr("outside"));
}
}  // namespace
