// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What MRPT 2.5.8 says of Debian's VLP-16 scan: the bytes and the calibration are those we decode,
// and each of the points that it yields (half of them) is one of ours.
#include "support/data.h"
#include "support/velodyne_capture.h"

#include <traverse/points/velodyne_scan.h>
#include <traverse/sensors/exact_angle.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace traverse::testing
{
namespace
{
using mrpt::obs::CObservationVelodyneScan;

CObservationVelodyneScan::Ptr scanIn(const std::string& file)
{
  mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CObservationVelodyneScan, mrpt::obs));
  mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CSensoryFrame, mrpt::obs));
  mrpt::io::CFileGZInputStream stream(file);
  auto archive = mrpt::serialization::archiveFrom(stream);
  const auto object = archive.ReadObject();
  if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
  {
    return frame->getObservationByClass<CObservationVelodyneScan>();
  }
  return std::dynamic_pointer_cast<CObservationVelodyneScan>(object);
}

class DebiansVlp16ScanInMrpt : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    const std::string file = mrptData("test_velodyne_VLP16.rawlog");
    TRAVERSE_NEEDS(file);
    scan_ = scanIn(file);
    ASSERT_TRUE(scan_);
    capture_ = captureInRawlog(file);
  }

  CObservationVelodyneScan::Ptr scan_;
  Capture capture_;
};

TEST_F(DebiansVlp16ScanInMrpt, HasThePacketsThatWeFind)
{
  ASSERT_EQ(scan_->scan_packets.size(), capture_.packets.size());
  const auto* theirs = reinterpret_cast<const uint8_t*>(scan_->scan_packets.data());
  for (const auto& packet : capture_.packets)
  {
    EXPECT_TRUE(std::equal(packet.begin(), packet.end(), theirs));
    theirs += packet.size();
  }
}

TEST_F(DebiansVlp16ScanInMrpt, CarriesTheCalibrationOfOurTable)
{
  const auto& ours = sensors::factoryCalibration(sensors::VelodyneModel::vlp16);
  ASSERT_GE(scan_->calibration.laser_corrections.size(), ours.lasers.size());
  for (size_t i = 0; i < ours.lasers.size(); ++i)
  {
    const auto& theirs = scan_->calibration.laser_corrections[i];
    EXPECT_NEAR(theirs.verticalCorrection, ours.lasers[i].elevation_rad * 180 / M_PI, 1e-9);
    EXPECT_EQ(theirs.azimuthCorrection, 0);
    EXPECT_EQ(theirs.distanceCorrection, 0);
    EXPECT_EQ(theirs.verticalOffsetCorrection, 0);
    EXPECT_EQ(theirs.horizontalOffsetCorrection, 0);
  }
}

TEST_F(DebiansVlp16ScanInMrpt, YieldsPointsThatAreAllAmongOurs)
{
  scan_->minRange = 0;
  CObservationVelodyneScan::TGeneratePointCloudParameters params;
  params.minDistance = 0;
  scan_->generatePointCloud(params);
  const auto& theirs = scan_->point_cloud;
  const auto views = capture_.views();
  points::VelodyneInput input;
  input.packets = views;
  const points::ScanBuffer ours = points::decodeVelodyne(input).scan;
  // In the packets' order on both sides: each of theirs is the next of ours at its place.
  size_t i = 0;
  size_t found = 0;
  double farthest = 0;
  for (size_t t = 0; t < theirs.size(); ++t)
  {
    // 0.02 degrees: its azimuth is rounded to 0.01, and its step is a median over the whole scan.
    const double range = std::hypot(theirs.x[t], theirs.y[t], theirs.z[t]);
    const double tolerance_m = 4e-4 * range + 1e-3;
    const auto distance = [&](size_t k) {
      return std::hypot(ours.x[k] - theirs.x[t], ours.y[k] - theirs.y[t], ours.z[k] - theirs.z[t]);
    };
    size_t k = i;
    while (k < ours.size() && distance(k) > tolerance_m)
    {
      ++k;
    }
    if (k < ours.size())
    {
      ++found;
      farthest = std::max<double>(farthest, distance(k));
      i = k + 1;
    }
  }
  EXPECT_EQ(found, theirs.size());
  EXPECT_GE(ours.size(), 2 * theirs.size() - 30);
}
}  // namespace
}  // namespace traverse::testing
