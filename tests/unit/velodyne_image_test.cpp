// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simulated_velodyne.h"

#include <traverse/points/velodyne_scan.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace traverse::testing
{
namespace
{
using points::Beam;
using sensors::VelodyneModel;

/** Everything is so many counts away. */
SimulatedVelodyne::World sphere(uint16_t count)
{
  return [count](int, double) {
    return std::array<sensors::VelodyneReturn, 2>{{{count, 51}, {count, 51}}};
  };
}

constexpr int kPacketsPerTurnVlp16 = 76;  // 75.35 at 10 Hz

TEST(VelodyneImage, HasRowsByElevationAndColumnsCounterClockwise)
{
  SimulatedVelodyne sensor;
  sensor.start_deg = 100;
  const auto image = decode(sensor.run(20, sphere(5000))).image;
  EXPECT_EQ(image.rows, 16);
  EXPECT_EQ(image.columns, 20 * 24);
  EXPECT_FALSE(image.closes);
  for (int row = 0; row < image.rows; ++row)
  {
    for (int column = 0; column < image.columns; ++column)
    {
      const size_t i = image.index(row, column);
      EXPECT_NEAR(image.elevation_rad[i], (2 * row - 15) * std::numbers::pi / 180, 1e-6);
      if (column > 0)
      {
        const float step = std::remainder(
            image.azimuth_rad[i] - image.azimuth_rad[i - 1],
            static_cast<float>(2 * std::numbers::pi));
        ASSERT_GT(step, 0.002);
        ASSERT_LT(step, 0.005);  // 0.2 degrees a sequence
        ASSERT_LT(image.time_s[i], image.time_s[i - 1]);
      }
    }
  }
}

TEST(VelodyneImage, IsOneTurnThatCloses)
{
  const auto out = decode(SimulatedVelodyne{}.run(kPacketsPerTurnVlp16 + 20, sphere(5000)));
  EXPECT_TRUE(out.image.closes);
  // 360 / (3600 x 55.296e-6) = 1808.4 sequences, whole blocks.
  EXPECT_NEAR(out.image.columns, 1809, 2);
  EXPECT_EQ(out.scan.size(), (kPacketsPerTurnVlp16 + 20) * 384U) << "points are of all packets";
}

TEST(VelodyneImage, AgreesWithThePoints)
{
  SimulatedVelodyne sensor;
  sensor.model = VelodyneModel::vlp32c;
  const auto out = decode(sensor.run(40, sphere(5000)));
  std::multiset<std::pair<float, float>> points;
  for (size_t i = 0; i < out.scan.size(); ++i)
  {
    points.emplace(out.scan.time_s[i], out.scan.z[i]);
  }
  size_t hits = 0;
  for (size_t i = 0; i < out.image.size(); ++i)
  {
    if (out.image.beam[i] == Beam::hit)
    {
      ++hits;
      const auto z = static_cast<float>(
          static_cast<double>(out.image.range_m[i]) * std::sin(out.image.elevation_rad[i]));
      const auto near = points.lower_bound({out.image.time_s[i], z - 1e-4F});
      ASSERT_NE(near, points.end());
      EXPECT_EQ(near->first, out.image.time_s[i]);
      EXPECT_NEAR(near->second, z, 1e-4);  // floats of 20 m and of an angle
    }
  }
  EXPECT_EQ(hits, out.scan.size());
}

/** Widest difference of azimuth within a column, rad, from the beam of row 16 where there is one.
 */
float spreadOf(const points::RangeImage& image, int column)
{
  const float reference = image.azimuth_rad[image.index(16, column)];
  float from = 0;
  float to = 0;
  for (int row = 0; row < image.rows; ++row)
  {
    const float off = std::remainder(
        image.azimuth_rad[image.index(row, column)] - reference,
        static_cast<float>(2 * std::numbers::pi));
    from = off < from ? off : from;  // false for NaN: no laser fired there
    to = off > to ? off : to;
  }
  return to - from;
}

TEST(VelodyneImage, BringsLasersThatLookAsideIntoTheColumnsWhereTheyLook)
{
  SimulatedVelodyne sensor;
  sensor.model = VelodyneModel::vlp32c;
  for (const int packets : {60, 160})  // 143 degrees; more than a turn
  {
    const auto image = decode(sensor.run(packets, sphere(5000))).image;
    EXPECT_EQ(image.closes, packets == 160);
    for (int column = 0; column < image.columns; ++column)
    {
      // One column is 0.2 degrees; without the move it would be 8.4. Where a turn closes it may
      // overlap itself by a column.
      ASSERT_LT(spreadOf(image, column), 0.6 * std::numbers::pi / 180) << column;
    }
  }
}

TEST(VelodyneImage, TellsWhereNoLaserFired)
{
  SimulatedVelodyne sensor;
  sensor.model = VelodyneModel::vlp32c;
  const auto image = decode(sensor.run(10, sphere(5000))).image;
  EXPECT_EQ(std::count(image.beam.begin(), image.beam.end(), Beam::hit), 10 * 384);
  for (size_t i = 0; i < image.size(); ++i)
  {
    EXPECT_EQ(image.beam[i] == Beam::rejected, std::isnan(image.azimuth_rad[i]));
    EXPECT_EQ(image.beam[i] == Beam::hit, std::isfinite(image.range_m[i]));
  }
}
}  // namespace
}  // namespace traverse::testing
