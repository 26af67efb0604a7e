// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/exclude.h>
#include <traverse/points/organise.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace
{
using namespace traverse::points;

/** Rings of points around a sensor 2 m up, elevations -0.3, 0, 0.3 rad, 8 m off, every degree. */
ScanBuffer rings()
{
  ScanBuffer scan;
  scan.T_base_sensor.translation().z() = 2;
  for (const double up : {-0.3, 0.0, 0.3})
  {
    for (int i = 0; i < 360; ++i)
    {
      const double a = (i + 0.5) * std::numbers::pi / 180;
      scan.x.push_back(static_cast<float>(8 * std::cos(up) * std::cos(a)));
      scan.y.push_back(static_cast<float>(8 * std::cos(up) * std::sin(a)));
      scan.z.push_back(static_cast<float>(2 + 8 * std::sin(up)));
    }
  }
  return scan;
}

size_t hits(const RangeImage& image)
{
  return static_cast<size_t>(std::count(image.beam.begin(), image.beam.end(), Beam::hit));
}

TEST(Organise, PutsEveryPointIntoItsBeam)
{
  const RangeImage image = organise(rings().view(), {3, 360});
  EXPECT_EQ(hits(image), 3U * 360);
  for (size_t i = 0; i < image.size(); ++i)
  {
    EXPECT_NEAR(image.range_m[i], 8, 1e-5);  // floats of 8 m
  }
  EXPECT_NEAR(image.elevation_rad.front(), -0.3, 1e-5);
  EXPECT_NEAR(image.elevation_rad.back(), 0.3, 1e-5);
  EXPECT_TRUE(std::is_sorted(image.azimuth_rad.begin(), image.azimuth_rad.begin() + 360));
  EXPECT_TRUE(image.closes);
}

TEST(Organise, KeepsTheNearestOfABeamAndCallsTheRestRejected)
{
  ScanBuffer scan;
  scan.x = {5, 3, 4};
  scan.y = {0.01F, 0.006F, 0.008F};
  scan.z = {0, 0, 0};
  const RangeImage image = organise(scan.view(), {2, 16});
  EXPECT_EQ(hits(image), 1U);
  const auto at = std::find(image.beam.begin(), image.beam.end(), Beam::hit) - image.beam.begin();
  EXPECT_NEAR(image.range_m[at], 3, 1e-4);
  EXPECT_EQ(std::count(image.beam.begin(), image.beam.end(), Beam::no_return), 0);
}

TEST(Organise, OfNothingIsEmptyAndGridsAreChecked)
{
  EXPECT_EQ(organise(Scan{}).size(), 0U);
  EXPECT_THROW(organise(rings().view(), {0, 10}), std::invalid_argument);
  EXPECT_THROW(organise(rings().view(), {1 << 20, 1 << 20}), std::invalid_argument);
}

TEST(ExcludeBox, TakesTheOwnBodyOut)
{
  Decoded d;
  d.scan = rings();
  d.scan.ring.assign(d.scan.size(), 7);
  d.image = organise(d.scan.view(), {3, 360});
  const size_t before = d.scan.size();
  // The half of the middle ring that lies ahead.
  excludeBox(d, Eigen::AlignedBox3f(Eigen::Vector3f(0, -9, 1.5F), Eigen::Vector3f(9, 9, 2.5F)));
  EXPECT_EQ(before - d.scan.size(), 180U);
  EXPECT_EQ(d.rejects.of(Reject::excluded), 180U);
  EXPECT_EQ(d.scan.ring.size(), d.scan.size());
  EXPECT_EQ(hits(d.image), 3U * 360 - 180);
  EXPECT_TRUE(d.scan.time_s.empty()) << "a channel that was not there stays so";
}
}  // namespace
