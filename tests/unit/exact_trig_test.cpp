// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace traverse::geometry;

TEST(ExactTrig, AgreesWithTheLibrary)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 200'000; ++i)
  {
    const double y = any(random);
    const double x = any(random) * (i % 2 == 0 ? 1 : 1e-9);
    ASSERT_NEAR(angleOf(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
    ASSERT_NEAR(arcSine(y), std::asin(y), 1e-15 / std::sqrt(1 - y * y)) << y;
    const double angle = 100 * x;
    // Rounding of pi / 2 and of its multiple.
    const double tolerance = 2e-15 + 2e-16 * std::abs(angle);
    ASSERT_NEAR(sinCosOfAny(angle).sin, std::sin(angle), tolerance) << angle;
    ASSERT_NEAR(sinCosOfAny(angle).cos, std::cos(angle), tolerance) << angle;
  }
}

TEST(ExactTrig, KnowsTheAxes)
{
  EXPECT_EQ(angleOf(0, 1), 0);
  EXPECT_EQ(angleOf(1, 0), kPi / 2);
  EXPECT_EQ(angleOf(-1, 0), -kPi / 2);
  EXPECT_EQ(angleOf(0, -1), kPi);
  EXPECT_EQ(angleOf(0, 0), 0);
  EXPECT_EQ(arcSine(1), kPi / 2);
}

TEST(ExactTrig, TakesAnyNumber)
{
  // The reduction by the rounded period loses 1e-16 a turn.
  EXPECT_NEAR(sinCosOfAny(12345.678).sin, std::sin(12345.678), 1e-12);
  EXPECT_LE(std::abs(sinCosOfAny(1e300).cos), 1);
  for (const double none : {std::numeric_limits<double>::infinity(), std::nan("")})
  {
    EXPECT_TRUE(std::isnan(sinCosOfAny(none).sin));
    EXPECT_TRUE(std::isnan(sinCosOfAny(none).cos));
  }
  EXPECT_TRUE(std::isnan(angleOf(std::nan(""), 1)));
}
}  // namespace
