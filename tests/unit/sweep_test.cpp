// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/range_row.h>
#include <traverse/points/sweep.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace
{
using namespace traverse::points;
constexpr double kStep = std::numbers::pi / 18;  // 10 degrees
constexpr int kBeams = 13;

/** A row of beams from -60 to 60 degrees of bearing, the scanner's nose `up_rad` above level, on an
 * axis at (0.2, 0, 1). */
Decoded rowAt(double up_rad, double t_s, float range_m = 5)
{
  const std::vector<float> ranges(kBeams, range_m);
  RangeRow row;
  row.stamp = static_cast<TimeNs>(1'000'000'000'000 + t_s * 1e9);
  row.range_m = ranges;
  row.first_bearing_rad = -(kBeams / 2) * kStep;
  row.step_rad = kStep;
  row.sensor_max_range_m = 80;
  row.T_base_sensor.translation() = Eigen::Vector3d(0.2, 0, 1);
  row.T_base_sensor.linear() =
      Eigen::AngleAxisd(-up_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return decodeRow(row);
}

/** Rows up from -0.4 to 0.4 in steps of 0.1, and the first row back. */
std::optional<Decoded> sweepUp(SweepCollector& collector)
{
  for (int i = 0; i <= 8; ++i)
  {
    EXPECT_FALSE(collector.add(rowAt(-0.4 + 0.1 * i, 0.1 * i)));
  }
  return collector.add(rowAt(0.3, 0.9));
}

TEST(Sweep, EndsWhereTheTiltTurnsRound)
{
  SweepCollector collector;
  const auto sweep = sweepUp(collector);
  ASSERT_TRUE(sweep);
  EXPECT_EQ(sweep->image.rows, 9);
  EXPECT_EQ(sweep->image.columns, kBeams);
  EXPECT_EQ(sweep->scan.size(), 9U * kBeams);
  EXPECT_EQ(collector.finish()->image.rows, 1);
  EXPECT_FALSE(collector.finish());
}

TEST(Sweep, BeamsHaveTheElevationAndAzimuthOfTheSpecification)
{
  SweepCollector collector;
  const auto sweep = sweepUp(collector);
  for (int row = 0; row < 9; ++row)
  {
    for (int column = 0; column < kBeams; ++column)
    {
      const double b = (column - kBeams / 2) * kStep;
      const double p = -0.4 + 0.1 * row;
      const size_t i = sweep->image.index(row, column);
      // Both angles are kept as floats below 2 rad.
      EXPECT_NEAR(sweep->image.elevation_rad[i], std::asin(std::cos(b) * std::sin(p)), 1e-6);
      EXPECT_NEAR(
          sweep->image.azimuth_rad[i], std::atan2(std::sin(b), std::cos(b) * std::cos(p)), 1e-6);
      EXPECT_NEAR(sweep->image.range_m[i], 5, 1e-5);
    }
  }
}

TEST(Sweep, EveryPointHasTheTimeOfItsRow)
{
  SweepCollector collector;
  const auto sweep = sweepUp(collector);
  EXPECT_EQ(sweep->scan.stamp, 1'000'000'000'000);
  EXPECT_FLOAT_EQ(sweep->scan.time_s.front(), 0);
  EXPECT_FLOAT_EQ(sweep->scan.time_s.back(), 0.8F);
  EXPECT_EQ(sweep->scan.ring.back(), 8);
}

TEST(Sweep, RowsOfADownwardSweepAreSortedByElevation)
{
  SweepCollector collector;
  for (const double up : {0.2, 0.1, 0.0})
  {
    collector.add(rowAt(up, 0.2 - up));
  }
  const auto sweep = collector.finish();
  EXPECT_LT(sweep->image.elevation_rad[kBeams / 2], 0.01);
  EXPECT_FLOAT_EQ(sweep->scan.time_s.front(), 0.2F) << "the lowest row came last";
}

TEST(Sweep, ASlowTiltTurnsRoundToo)
{
  SweepCollector collector;
  const double step = 5e-4;  // of the tilt, below the limit for a single step
  std::optional<Decoded> done;
  for (int i = 0; i < 40 && !done; ++i)
  {
    done = collector.add(rowAt(step * (20 - std::abs(i - 20)), 0.01 * i));
  }
  ASSERT_TRUE(done);
  EXPECT_NEAR(done->image.rows, 25, 1);
}

TEST(Sweep, APauseOrATimeThatGoesBackEndsIt)
{
  SweepCollector collector;
  collector.add(rowAt(0, 0));
  EXPECT_TRUE(collector.add(rowAt(0.1, 5)));
  EXPECT_TRUE(collector.add(rowAt(0.2, 1)));
}

TEST(Sweep, WhatMetNothingKeepsItsDirection)
{
  SweepCollector collector;
  collector.add(rowAt(0.1, 0, 80));
  collector.add(rowAt(0.2, 0.1, 80));
  const auto sweep = collector.finish();
  EXPECT_EQ(sweep->scan.size(), 0U);
  EXPECT_EQ(sweep->image.beam[0], Beam::no_return);
  EXPECT_NEAR(sweep->image.elevation_rad[kBeams / 2], 0.1, 1e-6);
}
}  // namespace
