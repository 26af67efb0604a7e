// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/poses/timing.h>

#include <gtest/gtest.h>

namespace
{
using namespace traverse;
using namespace traverse::poses;
constexpr TimeNs kMs = 1'000'000;

TEST(Timing, TellsRateGapsAndOrder)
{
  std::vector<poses::TimeNs> stamps;
  stamps.reserve(21);
  for (int i = 0; i < 20; ++i)
  {
    stamps.push_back((i < 10 ? 100 * i : 100 * i + 700) * kMs);
  }
  std::swap(stamps[3], stamps[4]);
  stamps.push_back(stamps.back());
  const Timing timing = timingOf(stamps);
  EXPECT_DOUBLE_EQ(timing.rateHz(), 10);
  EXPECT_DOUBLE_EQ(timing.longest_period_s, 0.8);
  ASSERT_EQ(timing.gaps.size(), 1U);
  EXPECT_EQ(timing.gaps[0].from_ns, 900 * kMs);
  EXPECT_EQ(timing.backward, 1U);
  EXPECT_EQ(timing.repeated, 1U);
}

TEST(Timing, OfOneStampIsNothing)
{
  EXPECT_EQ(timingOf(std::vector<poses::TimeNs>{5, 5}).rateHz(), 0);
  EXPECT_EQ(timingOf({}).median_period_s, 0);
}
}  // namespace
