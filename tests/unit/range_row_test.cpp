// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/range_row.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace
{
using namespace traverse::points;
using ::testing::ElementsAre;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

RangeRow row(std::span<const float> range_m, std::span<const char> valid = {})
{
  RangeRow r;
  r.range_m = range_m;
  r.valid = valid;
  r.first_bearing_rad = -std::numbers::pi / 2;
  r.step_rad = std::numbers::pi / 4;
  r.sensor_max_range_m = 80;
  r.limits = {0.5F, 30};
  return r;
}

TEST(RangeRow, PutsPointsWhereTheBearingSays)
{
  const std::vector<float> ranges = {1, 2, 3, 4, 5};
  RangeRow r = row(ranges);
  r.T_base_sensor.translation() = Eigen::Vector3d(10, 0, 0.3);
  const Decoded d = decodeRow(r);
  ASSERT_EQ(d.scan.size(), 5U);
  // Directions are kept to 2^-40, coordinates as floats of at most 13 m.
  EXPECT_NEAR(d.scan.x[2], 13, 1e-6);
  EXPECT_NEAR(d.scan.y[0], -1, 1e-6);
  EXPECT_NEAR(d.scan.y[4], 5, 1e-6);
  EXPECT_NEAR(d.scan.y[3], 4 / std::sqrt(2.0), 1e-6);
  EXPECT_THAT(d.scan.z, ElementsAre(0.3F, 0.3F, 0.3F, 0.3F, 0.3F));
  EXPECT_EQ(d.image.rows, 1);
  EXPECT_EQ(d.image.columns, 5);
  EXPECT_EQ(d.image.max_range_m, 30);
}

TEST(RangeRow, TellsNoReturnFromNonsense)
{
  //                               hit nan inf -inf  <0  near far  none  max   1e30
  const std::vector<float> ranges = {1, kNan, kInf, -kInf, -1, 0.1F, 40, 0, 80, 1e30F};
  const std::vector<char> valid = {1, 1, 1, 1, 1, 1, 1, 0, 1, 1};
  const Decoded d = decodeRow(row(ranges, valid));
  EXPECT_THAT(
      d.image.beam,
      ElementsAre(
          Beam::hit, Beam::rejected, Beam::rejected, Beam::rejected, Beam::rejected, Beam::rejected,
          Beam::no_return, Beam::no_return, Beam::no_return, Beam::no_return));
  EXPECT_EQ(d.scan.size(), 1U);
  EXPECT_EQ(d.rejects.of(Reject::nonfinite), 3U);
  EXPECT_EQ(d.rejects.of(Reject::below_range), 2U);
  EXPECT_EQ(d.rejects.of(Reject::beyond_range), 1U);
  EXPECT_EQ(d.rejects.of(Reject::no_return), 3U);
  for (size_t i = 1; i < ranges.size(); ++i)
  {
    EXPECT_TRUE(std::isnan(d.image.range_m[i])) << i;
  }
}

TEST(RangeRow, AValueFlaggedBadWithinReachMeansNothing)
{
  const std::vector<float> ranges = {5, 80};
  const std::vector<char> valid = {0, 0};
  const Decoded d = decodeRow(row(ranges, valid));
  EXPECT_THAT(d.image.beam, ElementsAre(Beam::rejected, Beam::no_return));
  EXPECT_EQ(d.rejects.of(Reject::flagged), 1U);
}

TEST(RangeRow, AClockwiseScannerHasColumnsCounterClockwiseToo)
{
  const std::vector<float> ranges = {1, 2, 3};
  RangeRow r = row(ranges);
  r.first_bearing_rad = 0.5;
  r.step_rad = -0.5;
  const Decoded d = decodeRow(r);
  EXPECT_THAT(d.image.azimuth_rad, ElementsAre(-0.5F, 0.0F, 0.5F));
  EXPECT_THAT(d.image.range_m, ElementsAre(3, 2, 1));
  EXPECT_FALSE(d.image.closes);
}

TEST(RangeRow, AFullTurnCloses)
{
  const std::vector<float> ranges(360, 2.0F);
  RangeRow r = row(ranges);
  r.first_bearing_rad = -std::numbers::pi;
  r.step_rad = 2 * std::numbers::pi / 360;
  EXPECT_TRUE(decodeRow(r).image.closes);
}

TEST(RangeRow, EmptyIsEmptyAndWrongLengthsAreRefused)
{
  EXPECT_EQ(decodeRow(row({})).image.rows, 0);
  const std::vector<float> ranges = {1, 2};
  const std::vector<char> valid = {1};
  EXPECT_THROW(decodeRow(row(ranges, valid)), std::invalid_argument);
  RangeRow r = row(ranges);
  r.step_rad = std::nan("");
  EXPECT_THROW(decodeRow(r), std::invalid_argument);
}
}  // namespace
