// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/convert.h>
#include <traverse/observations/to_scan.h>

#include <mrpt/maps/CColouredPointsMap.h>
#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <support/synthetic_logs.h>

namespace
{
using namespace traverse;
using namespace traverse::observations;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

ScanResult decoded(const mrpt::obs::CObservation& o, const ObservationParams& params = {})
{
  return toScan(o, params);
}

TEST(ToScan, Reads2DScansWithTheSensorsPose)
{
  auto scan = traverse::testing::laserScan(0, 5);
  scan.sensorPose = mrpt::poses::CPose3D(1, 0, 0.5, mrpt::DEG2RAD(90.0), 0, 0);
  const ScanResult result = decoded(scan);
  ASSERT_EQ(result.outcome, Outcome::scan) << result.reason;
  const points::ScanBuffer& s = result.decoded.scan;
  ASSERT_EQ(s.size(), 181U);
  EXPECT_EQ(s.stamp, traverse::testing::kLogStart);
  EXPECT_EQ(s.sensor_label, "LASER");
  // The first beam looks 90 degrees to the right of a sensor that looks to the left: ahead.
  EXPECT_NEAR(s.x[0], 6, 1e-5);
  EXPECT_NEAR(s.y[0], 0, 1e-5);
  EXPECT_NEAR(s.z[0], 0.5, 1e-6);
}

TEST(ToScan, NonFiniteRangesAreCountedNotUsed)
{
  auto scan = traverse::testing::laserScan(0, 5);
  scan.setScanRange(0, kNan);
  scan.setScanRange(1, -std::numeric_limits<float>::infinity());
  scan.setScanRange(2, 1e30F);
  const ScanResult result = decoded(scan);
  EXPECT_EQ(result.decoded.scan.size(), 178U);
  EXPECT_EQ(result.decoded.rejects.of(points::Reject::nonfinite), 2U);
  EXPECT_EQ(result.decoded.rejects.of(points::Reject::no_return), 1U);
}

TEST(ToScan, ScansOfOneBeamAndOfNoneAreScans)
{
  auto scan = traverse::testing::laserScan(0);
  scan.resizeScanAndAssign(1, 3, true);
  EXPECT_FLOAT_EQ(decoded(scan).decoded.scan.x.at(0), 3);
  scan.resizeScan(0);
  EXPECT_EQ(decoded(scan).outcome, Outcome::scan);
}

TEST(ToScan, APoseOfTheSensorThatIsNoneIsRefused)
{
  auto scan = traverse::testing::laserScan(0);
  scan.sensorPose = mrpt::poses::CPose3D(kNan, 0, 0);
  EXPECT_EQ(decoded(scan).outcome, Outcome::rejected);
  scan.sensorPose = mrpt::poses::CPose3D(1e30, 0, 0);
  EXPECT_EQ(decoded(scan).outcome, Outcome::rejected);
  scan = traverse::testing::laserScan(0);
  scan.aperture = kNan;
  EXPECT_EQ(decoded(scan).outcome, Outcome::rejected);
}

TEST(ToScan, TakesTheSensorsAskedForOnly)
{
  ObservationParams params;
  params.sensor_labels = "front rear";
  auto scan = traverse::testing::laserScan(0);
  EXPECT_EQ(decoded(scan, params).outcome, Outcome::ignored);
  scan.sensorLabel = "rear";
  EXPECT_EQ(decoded(scan, params).outcome, Outcome::scan);
}

TEST(ToScan, LeavesTheOwnBodyOut)
{
  ObservationParams params;
  params.own_body_min_m = {0, -10, -1};
  params.own_body_max_m = {4.9, 10, 1};
  const ScanResult result = decoded(traverse::testing::laserScan(0, 5), params);
  EXPECT_GT(result.decoded.rejects.of(points::Reject::excluded), 100U);
  EXPECT_GT(result.decoded.scan.size(), 10U);
  for (const float x : result.decoded.scan.x)
  {
    // The two beams straight to the sides lie 2e-7 m behind the box' face.
    EXPECT_TRUE(x > 4.9F || x < 1e-6F);
  }
}

TEST(ToScan, ARotatingScanNeedsElevations)
{
  mrpt::obs::CObservationRotatingScan scan;
  scan.rowCount = 2;
  scan.columnCount = 3;
  scan.rangeResolution = 0.01;
  scan.startAzimuth = -1;
  scan.azimuthSpan = 2;
  scan.maxRange = 100;
  scan.rangeImage.resize(2, 3);
  scan.rangeImage.fill(500);
  scan.rangeImage(0, 0) = 0;
  EXPECT_THAT(decoded(scan).reason, HasSubstr("rotating_elevations_deg"));
  ObservationParams params;
  params.rotating_elevations_deg = {30};
  EXPECT_THAT(decoded(scan, params).reason, HasSubstr("2 rows"));
  params.rotating_elevations_deg = {30, 0};
  const ScanResult result = decoded(scan, params);
  ASSERT_EQ(result.outcome, Outcome::scan) << result.reason;
  EXPECT_THAT(result.decoded.scan.ring, ElementsAre(0, 0, 0, 1, 1));
  EXPECT_NEAR(result.decoded.scan.z.back(), 2.5, 1e-6) << "5 m at 30 degrees";
  EXPECT_EQ(result.decoded.image.beam[3], points::Beam::no_return);
}

TEST(ToScan, ARotatingScanThatLiesAboutItsSizeIsRefused)
{
  mrpt::obs::CObservationRotatingScan scan;
  scan.rowCount = 1;
  scan.columnCount = 1000;
  scan.rangeResolution = 0.01;
  EXPECT_EQ(decoded(scan).outcome, Outcome::rejected);
}

TEST(ToScan, CloudsKeepIntensityAndLoseTheOrigin)
{
  mrpt::obs::CObservationPointCloud cloud;
  auto points = mrpt::maps::CPointsMapXYZI::Create();
  points->insertPointRGB(1, 2, 3, 0.25F, 0, 0);
  points->insertPointRGB(0, 0, 0, 0.5F, 0, 0);
  points->insertPointRGB(kNan, 0, 0, 0.5F, 0, 0);
  points->insertPointRGB(4, 0, 0, kNan, 0, 0);
  cloud.pointcloud = points;
  cloud.sensorPose = mrpt::poses::CPose3D(0, 0, 1);
  const ScanResult result = decoded(cloud);
  ASSERT_EQ(result.outcome, Outcome::scan) << result.reason;
  EXPECT_THAT(result.decoded.scan.z, ElementsAre(4, 1));
  EXPECT_THAT(result.decoded.scan.intensity, ElementsAre(0.25F, 0));
  EXPECT_EQ(result.decoded.rejects.of(points::Reject::no_return), 1U);
  EXPECT_EQ(result.decoded.rejects.of(points::Reject::nonfinite), 1U);
  EXPECT_GT(result.decoded.image.size(), 0U);
}

TEST(ToScan, CloudsKeepColour)
{
  mrpt::obs::CObservationPointCloud cloud;
  auto points = mrpt::maps::CColouredPointsMap::Create();
  points->insertPointRGB(1, 2, 3, 1, 0.5F, 0);
  cloud.pointcloud = points;
  EXPECT_THAT(decoded(cloud).decoded.scan.rgb, ElementsAre(0xFF8000U));
}

TEST(ToScan, AnObservationWithoutACloudIsRefused)
{
  EXPECT_EQ(decoded(mrpt::obs::CObservationPointCloud()).outcome, Outcome::rejected);
  EXPECT_EQ(decoded(mrpt::obs::CObservation3DRangeScan()).outcome, Outcome::rejected);
}

TEST(ToScan, ADepthImageWithoutCalibrationIsRefused)
{
  mrpt::obs::CObservation3DRangeScan scan;
  scan.hasRangeImage = true;
  scan.rangeImage_setSize(4, 6);
  scan.rangeImage.fill(1000);
  scan.cameraParams.nrows = 4;
  scan.cameraParams.ncols = 6;
  EXPECT_THAT(decoded(scan).reason, HasSubstr("calibration"));
  scan.cameraParams.setIntrinsicParamsFromValues(5, 5, 3, 2);
  EXPECT_EQ(decoded(scan).decoded.scan.size(), 24U);
  scan.cameraParams.ncols = 7;
  EXPECT_EQ(decoded(scan).outcome, Outcome::rejected);
}

TEST(ToScan, VelodynePacketsOfNothingAreRefused)
{
  mrpt::obs::CObservationVelodyneScan scan;
  EXPECT_EQ(decoded(scan).decoded.scan.size(), 0U);
  scan.scan_packets.resize(3);
  EXPECT_EQ(decoded(scan).outcome, Outcome::rejected);
}

TEST(ToScan, PicturesAreNoScans)
{
  EXPECT_EQ(decoded(mrpt::obs::CObservationImage()).outcome, Outcome::ignored);
}

TEST(Convert, PosesGoThereAndBack)
{
  const mrpt::poses::CPose3D pose(1, -2, 3, 0.4, -0.5, 0.6);
  const mrpt::poses::CPose3D back = toPose3D(toIsometry(pose));
  EXPECT_NEAR(mrpt::poses::CPose3D(pose - back).norm(), 0, 1e-9);
  EXPECT_NEAR(back.yaw(), 0.4, 1e-9);
  EXPECT_NEAR(back.pitch(), -0.5, 1e-9);
  EXPECT_NEAR(back.roll(), 0.6, 1e-9);
}

TEST(Convert, TimesGoThereAndBackAndNoneIsNone)
{
  EXPECT_EQ(toTime(toTimePoint(traverse::testing::kLogStart)), traverse::testing::kLogStart);
  // MRPT's own idea of seconds since 1970.
  EXPECT_EQ(toTime(mrpt::Clock::fromDouble(1.6e9)), traverse::testing::kLogStart);
  EXPECT_FALSE(toTime(INVALID_TIMESTAMP));
  EXPECT_FALSE(toTime(mrpt::Clock::fromDouble(5.0)));
  EXPECT_FALSE(toTime(mrpt::Clock::time_point(mrpt::Clock::duration(INT64_MAX))));
  EXPECT_FALSE(toTime(mrpt::Clock::time_point(mrpt::Clock::duration(INT64_MIN))));
}

TEST(ObservationParams, AreCheckedTogether)
{
  ObservationParams params;
  checkTogether(params);
  params.own_body_min_m = {0, 0, 0};
  EXPECT_THROW(checkTogether(params), options::OptionError);
  params.own_body_max_m = {1, 1, -1};
  EXPECT_THROW(checkTogether(params), options::OptionError);
  params = {};
  params.min_range_m = 20;
  params.max_range_m = 10;
  EXPECT_THROW(checkTogether(params), options::OptionError);
}
}  // namespace
