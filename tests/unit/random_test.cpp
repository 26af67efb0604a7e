// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace traverse::simulation
{
namespace
{
TEST(Random, GivesTheSameNumbersForEver)
{
  Random random(42);
  EXPECT_EQ(random.bits(), 0xBDD732262FEB6E95U);  // SplitMix64's own first number for 42
  EXPECT_EQ(mixed({1, 2, 3}), mixed({1, 2, 3}));
  EXPECT_NE(mixed({1, 2, 3}), mixed({1, 3, 2}));
  EXPECT_NE(mixed({0}), mixed({0, 0}));
}

TEST(Random, UniformNumbersFillTheirInterval)
{
  Random random(7);
  std::array<int, 10> bins{};
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i)
  {
    const double u = random.uniform(-1, 1);
    ASSERT_GE(u, -1);
    ASSERT_LT(u, 1);
    ++bins[static_cast<size_t>((u + 1) * 5)];
  }
  for (const int n : bins)
  {
    EXPECT_NEAR(n, kDraws / 10.0, 5 * 95);  // five standard deviations
  }
}

TEST(Random, NormalNumbersHaveTheMomentsAndTailsOfTheDistribution)
{
  Random random(8);
  constexpr int kDraws = 200000;
  double sum = 0;
  double squares = 0;
  double fourths = 0;
  int beyond_three = 0;
  for (int i = 0; i < kDraws; ++i)
  {
    const double v = random.normal();
    sum += v;
    squares += v * v;
    fourths += v * v * v * v;
    beyond_three += std::abs(v) > 3 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.012);       // 5 / sqrt(n)
  EXPECT_NEAR(squares / kDraws, 1, 0.016);   // 5 sqrt(2 / n)
  EXPECT_NEAR(fourths / kDraws, 3, 0.11);    // 5 sqrt(96 / n)
  EXPECT_NEAR(beyond_three, 540, 5 * 23.2);  // 0.27 %
}

TEST(Random, ManyNormalNumbersAtOnceHaveTheBitsOfSingleOnes)
{
  for (size_t count = 0; count < 50; ++count)
  {
    Random one(count);
    Random many(count);
    std::vector<NormalDraw> draws(count);
    std::generate(draws.begin(), draws.end(), [&] { return many.drawNormal(); });
    std::vector<double> normals(count);
    normalsOf(draws, normals);
    for (const double normal : normals)
    {
      EXPECT_EQ(normal, one.normal());
    }
    EXPECT_EQ(one.bits(), many.bits());
  }
}

TEST(Random, AnIndexIsBelowItsBoundAndReachesAll)
{
  Random random(9);
  std::array<int, 3> seen{};
  for (int i = 0; i < 3000; ++i)
  {
    ++seen.at(random.index(3));
  }
  for (const int n : seen)
  {
    EXPECT_NEAR(n, 1000, 5 * 26);
  }
}
}  // namespace
}  // namespace traverse::simulation
