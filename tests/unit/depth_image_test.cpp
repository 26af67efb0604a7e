// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/depth_image.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{
using namespace traverse::points;

/** 4 x 3 pixels, principal point in pixel (1, 1), focal length 2 px. */
traverse::sensors::Pinhole camera()
{
  traverse::sensors::Pinhole c;
  c.columns = 4;
  c.rows = 3;
  c.fx_px = c.fy_px = 2;
  c.cx_px = c.cy_px = 1;
  return c;
}

DepthImage image(std::span<const uint16_t> values)
{
  DepthImage in;
  in.camera = camera();
  in.values = values;
  in.limits = {0.5F, 10};
  return in;
}

TEST(DepthImage, UnprojectsForwardLeftUp)
{
  std::array<uint16_t, 12> values{};
  values[0 * 4 + 3] = 2000;  // upper right: 2 m deep, 2 px right and 1 px up of the axis
  const Decoded d = decodeDepth(image(values));
  ASSERT_EQ(d.scan.size(), 1U);
  EXPECT_FLOAT_EQ(d.scan.x[0], 2);
  EXPECT_FLOAT_EQ(d.scan.y[0], -2);
  EXPECT_FLOAT_EQ(d.scan.z[0], 1);
  EXPECT_EQ(d.scan.ring[0], 2) << "row 0 is the lowest";
  const size_t at = d.image.index(2, 0);
  EXPECT_EQ(d.image.beam[at], Beam::hit) << "column 0 is the rightmost";
  EXPECT_FLOAT_EQ(d.image.range_m[at], 3);
  EXPECT_FLOAT_EQ(d.image.azimuth_rad[at], static_cast<float>(std::atan2(-1.0, 1.0)));
}

TEST(DepthImage, DistancesAreNotDepths)
{
  std::array<uint16_t, 12> values{};
  values[3] = 3000;
  DepthImage in = image(values);
  in.along_axis = false;
  const Decoded d = decodeDepth(in);
  EXPECT_FLOAT_EQ(d.scan.x[0], 2);
  EXPECT_FLOAT_EQ(d.image.range_m[d.image.index(2, 0)], 3);
}

TEST(DepthImage, AZeroMeansNothing)
{
  std::array<uint16_t, 12> values{};
  values[0] = 100;    // 0.1 m: too near
  values[1] = 20000;  // beyond
  const Decoded d = decodeDepth(image(values));
  EXPECT_EQ(d.scan.size(), 0U);
  EXPECT_EQ(d.rejects.of(Reject::flagged), 10U);
  EXPECT_EQ(d.rejects.of(Reject::below_range), 1U);
  EXPECT_EQ(d.rejects.of(Reject::beyond_range), 1U);
  EXPECT_EQ(d.image.beam[d.image.index(2, 2)], Beam::no_return);
  EXPECT_EQ(d.image.beam[d.image.index(0, 0)], Beam::rejected);
}

TEST(DepthImage, LooksColoursUpInTheOtherCamera)
{
  std::array<uint16_t, 12> values{};
  values[1 * 4 + 1] = 2000;             // on the axis
  values[1 * 4 + 3] = 2000;             // outside the other picture
  std::array<uint8_t, 2 * 8> pixels{};  // 2 x 2 pixels, rows of 8 bytes
  pixels[8 + 3] = 10;                   // pixel (1, 1): blue
  pixels[8 + 4] = 20;                   // green
  pixels[8 + 5] = 30;                   // red
  ColourImage colour;
  colour.camera = camera();
  colour.camera.columns = colour.camera.rows = 2;
  colour.bytes = pixels;
  colour.row_bytes = 8;
  colour.T_sensor_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  DepthImage in = image(values);
  in.colour = &colour;
  const Decoded d = decodeDepth(in);
  ASSERT_EQ(d.scan.rgb.size(), 2U);
  EXPECT_THAT(d.scan.rgb, ::testing::ElementsAre(0x000000U, 0x1E140AU));
}

TEST(DepthImage, TakesEveryStepthPixel)
{
  const std::vector<uint16_t> values(12, 1000);
  DepthImage in = image(values);
  in.step = 2;
  const Decoded d = decodeDepth(in);
  EXPECT_EQ(d.image.rows, 2);
  EXPECT_EQ(d.image.columns, 2);
  EXPECT_EQ(d.scan.size(), 4U);
}

TEST(DepthImage, RefusesWhatDoesNotFit)
{
  const std::vector<uint16_t> values(11, 1000);
  EXPECT_THROW(decodeDepth(image(values)), std::invalid_argument);
  const std::vector<uint16_t> right(12, 1000);
  DepthImage in = image(right);
  in.camera.fx_px = 0;
  EXPECT_THROW(decodeDepth(in), std::invalid_argument);
  in = image(right);
  ColourImage colour;
  colour.camera = camera();
  in.colour = &colour;
  EXPECT_THROW(decodeDepth(in), std::invalid_argument) << "a picture without bytes";
}
}  // namespace
