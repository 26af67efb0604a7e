// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/observations/to_scan.h>

#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <support/ros_bag.h>
#include <tuple>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationImage;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::SizeIs;

/** A camera's optical frame on the vehicle: looks ahead, 1 m high. */
msgs::TransformStamped opticalFrame(const std::string& name, double left_m = 0)
{
  auto t = rosTransform(0, "base_link", name, 0, 0);
  t.transform.translation.y = left_m;
  t.transform.translation.z = 1;
  t.transform.rotation.x = -0.5;
  t.transform.rotation.y = 0.5;
  t.transform.rotation.z = -0.5;
  t.transform.rotation.w = 0.5;
  return t;
}

std::string floatPixel(float metres)
{
  std::string pixel(sizeof(metres), '\0');
  std::memcpy(pixel.data(), &metres, sizeof(metres));
  return pixel;
}

TEST(RosBagImages, OfEachByteEncodingHaveTheirColours)
{
  const std::vector<std::pair<std::string, std::string>> encodings = {
      {"rgb8", "\x01\x02\x03"},
      {"bgr8", "\x03\x02\x01"},
      {"rgba8", "\x01\x02\x03\x7f"},
      {"bgra8", "\x03\x02\x01\x7f"}};
  for (const auto& [encoding, pixel] : encodings)
  {
    BagFile bag;
    bag.write("/cam/image_raw", 0, rosImage(0, "cam", encoding, pixel));
    const auto image = observationOf<CObservationImage>(readBag(bag));
    ASSERT_TRUE(image->image.isColor()) << encoding;
    ASSERT_EQ(image->image.getWidth(), 32U);
    ASSERT_EQ(image->image.getHeight(), 24U);
    const uint8_t* last = image->image.ptr<uint8_t>(31, 23);
    EXPECT_EQ(last[0], 3) << encoding << ": blue first";
    EXPECT_EQ(last[1], 2) << encoding;
    EXPECT_EQ(last[2], 1) << encoding;
  }
  BagFile grey;
  grey.write("/cam/image_raw", 0, rosImage(0, "cam", "mono8", "\x09"));
  const auto image = observationOf<CObservationImage>(readBag(grey));
  EXPECT_FALSE(image->image.isColor());
  EXPECT_EQ(*image->image.ptr<uint8_t>(31, 23), 9);
}

TEST(RosBagImages, TakeTheCalibrationBesideThem)
{
  BagFile bag;
  bag.writeTf(opticalFrame("cam"));
  bag.write("/cam/image_raw", 0, rosImage(0, "cam", "rgb8", "abc"));
  bag.write("/cam/image_rect_color", 1, rosImage(1, "cam", "rgb8", "abc"));
  bag.write("/cam/camera_info", 2, rosCamera("cam"));
  const BagReading r = readBag(bag);
  const auto raw = observationOf<CObservationImage>(r, 0);
  EXPECT_EQ(raw->cameraParams.fx(), 30);
  EXPECT_EQ(raw->cameraParams.cy(), 12);
  EXPECT_EQ(raw->cameraParams.k3(), 0.05);
  EXPECT_EQ(raw->cameraPose.z(), 1);
  const auto rectified = observationOf<CObservationImage>(r, 1);
  EXPECT_EQ(rectified->cameraParams.fx(), 29);
  EXPECT_EQ(rectified->cameraParams.k1(), 0);
}

TEST(RosBagImages, OfDepthSeePointsAheadOfTheVehicle)
{
  const std::vector<std::tuple<std::string, std::string, std::string>> encodings = {
      {"16UC1", std::string("\xd0\x07", 2), std::string("\xa0\x0f", 2)},
      {"32FC1", floatPixel(2), floatPixel(4)}};
  for (const auto& [encoding, two_m, four_m] : encodings)
  {
    BagFile bag;
    bag.writeTf(opticalFrame("depth"));
    bag.write("/cam/camera_info", 0, rosCamera("depth"));
    auto image = rosImage(0, "depth", encoding, two_m);
    std::copy(four_m.begin(), four_m.end(), image.data.begin());
    bag.write("/cam/image_rect_raw", 0, image);
    const auto depth = observationOf<CObservation3DRangeScan>(readBag(bag));
    const auto scan = observations::toScan(*depth, {}).decoded.scan;
    ASSERT_EQ(scan.size(), 32U * 24U) << encoding;
    const auto far = std::max_element(scan.x.begin(), scan.x.end());
    const auto i = static_cast<size_t>(far - scan.x.begin());
    // Rotations are rounded to 2^-40, points are floats.
    EXPECT_NEAR(scan.x[i], 4, 1e-5) << encoding;
    EXPECT_NEAR(*std::min_element(scan.x.begin(), scan.x.end()), 2, 1e-5) << encoding;
    // The first pixel is up and to the left: 15 and 11 pixels from the principal point of P.
    EXPECT_NEAR(scan.y[i], 4 * 15 / 29.0, 1e-5);
    EXPECT_NEAR(scan.z[i], 1 + 4 * 11 / 28.0, 1e-5);
  }
}

TEST(RosBagImages, DepthTakesTheColourOfItsStamp)
{
  BagFile bag;
  bag.writeTf(opticalFrame("depth"));
  bag.writeTf(opticalFrame("colour", 0.1));
  auto camera = rosCamera("depth");
  camera.D.clear();
  bag.write("/cam/depth/camera_info", 0, camera);
  bag.write("/cam/rgb/camera_info", 0, camera);
  for (const double t : {0.0, 1.0})
  {
    bag.write("/cam/rgb/image", t, rosImage(t, "colour", "rgb8", "\x01\x02\x03"));
    bag.write("/cam/depth/image", t + 0.01, rosImage(t, "depth", "32FC1", floatPixel(2)));
  }
  bag.write("/cam/rgb/image", 2, rosImage(2, "colour", "rgb8", "\x01\x02\x03"));
  const BagReading r = readBag(bag);
  ASSERT_THAT(r.entries, SizeIs(3));
  const auto depth = observationOf<CObservation3DRangeScan>(r, 1);
  ASSERT_TRUE(depth->hasIntensityImage);
  EXPECT_EQ(depth->cameraParamsIntensity.fx(), 30);
  EXPECT_NEAR(depth->relativePoseIntensityWRTDepth.y(), 0.1, 1e-9);
  EXPECT_NEAR(depth->relativePoseIntensityWRTDepth.x(), 0, 1e-9);
  EXPECT_FALSE(observationOf<CObservationImage>(r)->image.isEmpty()) << "the one without depth";
  const auto scan = observations::toScan(*depth, {}).decoded.scan;
  EXPECT_THAT(scan.rgb, Contains(0x010203U));
}

TEST(RosBagImages, DepthTooFarForItsClassIsCountedNotWrapped)
{
  BagFile bag;
  bag.write("/cam/camera_info", 0, rosCamera("depth"));
  bag.write("/cam/image", 0, rosImage(0, "depth", "32FC1", floatPixel(70)));
  const BagReading r = readBag(bag);
  EXPECT_THAT(r.report.skipped, Contains(Pair(HasSubstr("beyond 65.535 m"), 32 * 24)));
  EXPECT_EQ(observationOf<CObservation3DRangeScan>(r)->rangeImage(0, 0), 0);
}

TEST(RosBagImages, ThatCannotBeUsedAreTold)
{
  BagFile bag;
  bag.write("/a/image", 0, rosImage(0, "x", "32FC1", floatPixel(2)));
  bag.write("/b/image", 0, rosImage(0, "x", "bayer_rggb8", "a"));
  auto narrow = rosImage(0, "x", "rgb8", "abc");
  narrow.step = 32;
  bag.write("/c/image", 0, narrow);
  const BagReading r = readBag(bag);
  EXPECT_THAT(r.entries, SizeIs(0));
  EXPECT_THAT(r.report.skipped, Contains(Pair(HasSubstr("/a/image: a depth image without"), 1)));
  EXPECT_THAT(r.report.skipped, Contains(Pair(HasSubstr("'bayer_rggb8'"), 1)));
  EXPECT_THAT(r.report.skipped, Contains(Pair(HasSubstr("/c/image: Image: rows shorter"), 1)));
}
}  // namespace
