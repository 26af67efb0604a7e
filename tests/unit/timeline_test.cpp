// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/timeline.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace traverse::formats;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int64_t kSecond = 1'000'000'000;

/** `count` stamps, `period` apart. */
std::vector<int64_t> steady(int64_t first, int64_t period, int count)
{
  std::vector<int64_t> stamps;
  for (int i = 0; i < count; ++i)
  {
    stamps.push_back(first + period * i);
  }
  return stamps;
}

std::string pageOf(const std::vector<TimelineRow>& rows)
{
  Report report;
  report.sections.push_back({"s", {Timeline{"Sensors", rows}}});
  return html(report);
}

size_t countOf(const std::string& what, const std::string& text)
{
  size_t count = 0;
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size())
  {
    ++count;
  }
  return count;
}

TEST(StampRhythm, PeriodIsTheUsualStepAndGapsAreThreeTimesIt)
{
  std::vector<int64_t> stamps = steady(0, kSecond / 10, 20);
  const auto late = steady(5 * kSecond, kSecond / 10, 10);
  stamps.insert(stamps.end(), late.begin(), late.end());
  const StampRhythm rhythm = rhythmOf(stamps);
  EXPECT_DOUBLE_EQ(rhythm.period_s.value(), 0.1);
  ASSERT_EQ(rhythm.gap_count, 1U);
  EXPECT_EQ(rhythm.gaps[0].from_ns, kSecond * 19 / 10);
  EXPECT_EQ(rhythm.gaps[0].to_ns, 5 * kSecond);
  EXPECT_DOUBLE_EQ(rhythm.longest_gap_s, 3.1);
}

TEST(StampRhythm, OrderAndRepetitionDoNotMatter)
{
  const StampRhythm rhythm = rhythmOf(std::vector<int64_t>{300, 100, 200, 200, 400});
  EXPECT_DOUBLE_EQ(rhythm.period_s.value(), 1e-7);
  EXPECT_EQ(rhythm.gap_count, 0U);
}

TEST(StampRhythm, NoneOneAndTheWidestStampsAreFine)
{
  EXPECT_FALSE(rhythmOf({}).period_s);
  EXPECT_FALSE(rhythmOf(std::vector<int64_t>{5, 5, 5}).period_s);
  const StampRhythm widest = rhythmOf(std::vector<int64_t>{
      std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()});
  EXPECT_NEAR(widest.period_s.value(), 18446744073.7, 1);
}

TEST(StampRhythm, OnlyTheLongestOfManyGapsAreKept)
{
  std::vector<int64_t> stamps;
  int64_t at = 0;
  for (int i = 0; i < 1000; ++i)
  {
    stamps.push_back(at);
    stamps.push_back(at + 1);
    stamps.push_back(at + 2);
    at += 100 + i;
  }
  const StampRhythm rhythm = rhythmOf(stamps);
  EXPECT_EQ(rhythm.gap_count, 999U);
  EXPECT_EQ(rhythm.gaps.size(), StampRhythm::kMostGaps);
  EXPECT_LT(rhythm.gaps.front().from_ns, rhythm.gaps.back().from_ns);
  EXPECT_EQ(rhythm.gaps.back().to_ns, stamps[2997]) << "the last is the longest";
}

TEST(Timeline, SaysRateGapsAndStampsOutOfOrder)
{
  std::vector<int64_t> stamps = steady(1'600'000'000 * kSecond, kSecond / 10, 100);
  stamps.insert(stamps.begin() + 50, stamps[20]);
  stamps.insert(stamps.begin() + 80, stamps[79]);
  stamps.push_back(stamps.back() + 2 * kSecond);
  const std::string page = pageOf({{"LIDAR", "CObservationVelodyneScan", 104, 1, 1, 1, stamps}});
  EXPECT_THAT(page, HasSubstr("LIDAR"));
  EXPECT_THAT(page, HasSubstr("CObservationVelodyneScan"));
  EXPECT_THAT(
      page,
      HasSubstr("104 \xC2\xB7 10 Hz \xC2\xB7 1 gaps, longest 2 s \xC2\xB7 1 backward \xC2\xB7 1 "
                "repeated \xC2\xB7 1 no clock"));
  EXPECT_THAT(page, HasSubstr("no observation from 9.900 s to 11.900 s"));
  EXPECT_EQ(countOf("class=\"gap\"", page), 1U);
  EXPECT_EQ(countOf("class=\"backward\"", page), 1U);
  EXPECT_EQ(countOf("class=\"repeated\"", page), 1U);
  EXPECT_THAT(page, HasSubstr("text-anchor=\"end\">11.9 s<"));
}

TEST(Timeline, SensorsShareOneTime)
{
  const std::string page = pageOf(
      {{"early", "T", 2, 0, 0, 0, {0, kSecond}},
       {"late", "T", 2, 0, 0, 0, {9 * kSecond, 10 * kSecond}}});
  EXPECT_THAT(page, HasSubstr("text-anchor=\"end\">10 s<"));
}

TEST(Timeline, OddSensorsAreDrawnAllTheSame)
{
  const std::string page = pageOf(
      {{"", "", 0, 0, 0, 0, {}},
       {"one", "T", 1, 0, 0, 0, {5}},
       {"bad", "T", 3, 0, 0, 3, {}},
       {"cut", "T", 1000, 0, 0, 0, {1, 2, 3}},
       {"widest",
        "T",
        2,
        1,
        0,
        0,
        {std::numeric_limits<int64_t>::max(), std::numeric_limits<int64_t>::min()}}});
  EXPECT_THAT(page, HasSubstr("(no label)"));
  EXPECT_THAT(page, HasSubstr("first 3 shown"));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
  EXPECT_THAT(page, Not(HasSubstr("inf")));
}

TEST(Timeline, SizeIsBoundedWhateverTheLog)
{
  TimelineRow row{"</text><script>", "<b>", 20'000, 0, 0, 0, {}};
  for (int i = 0; i < 20'000; ++i)
  {
    row.stamps_ns.push_back(int64_t{i * 7919 % 20'011} * kSecond);
  }
  const std::string page = pageOf(std::vector<TimelineRow>(100, row));
  EXPECT_LT(page.size(), 8'000'000U);
  EXPECT_THAT(page, HasSubstr("36 more are not shown"));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST(Timeline, SameSensorsGiveTheSameBytes)
{
  const std::vector<TimelineRow> rows = {{"a", "T", 3, 0, 0, 0, {1, 5, 3}}};
  EXPECT_EQ(pageOf(rows), pageOf(rows));
}
}  // namespace
