// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/vehicle.h>
#include <traverse/options/option.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using traverse::options::OptionError;
using namespace traverse::geometry;
using ::testing::HasSubstr;

double parsed(std::string_view text)
{
  double value = -1;
  traverse::options::parse({"max_slope_deg", "", {0, 90}}, text, value);
  return value;
}

TEST(Options, ReadsNumbersWhole)
{
  EXPECT_DOUBLE_EQ(parsed("1.5"), 1.5);
  for (const char* bad : {"", "abc", "1,5", "1.5x", "nan", "inf", "1e999", " 1", "0x10"})
  {
    EXPECT_THROW(parsed(bad), OptionError) << bad;
  }
}

TEST(Options, ErrorSaysKeyValueAndWhatIsAllowed)
{
  try
  {
    parsed("91");
    FAIL() << "91 is out of range";
  }
  catch (const OptionError& e)
  {
    EXPECT_THAT(e.what(), HasSubstr("max_slope_deg"));
    EXPECT_THAT(e.what(), HasSubstr("'91'"));
    EXPECT_THAT(e.what(), HasSubstr("0 to 90"));
  }
}

TEST(Options, SetsOneKeyOfAStruct)
{
  Vehicle v;
  EXPECT_TRUE(traverse::options::set(v, "height_m", "3"));
  EXPECT_TRUE(traverse::options::set(v, "footprint_xs_m", "1 2  3"));
  EXPECT_FALSE(traverse::options::set(v, "heigth_m", "3"));
  EXPECT_DOUBLE_EQ(v.height_m, 3);
  EXPECT_THAT(v.footprint_xs_m, ::testing::ElementsAre(1, 2, 3));
}

TEST(Options, FormatsWhatItReads)
{
  for (const traverse::options::Row& row : traverse::options::rows(Vehicle{}))
  {
    Vehicle other;
    EXPECT_TRUE(traverse::options::set(other, row.key, row.value)) << row.key;
    EXPECT_EQ(other, Vehicle{}) << row.key;
  }
}

TEST(Options, KnowsTheNearestKey)
{
  EXPECT_EQ(
      traverse::options::nearest("max_slop_deg", {"height_m", "max_slope_deg"}), "max_slope_deg");
  EXPECT_EQ(traverse::options::nearest("colour", {"height_m", "max_slope_deg"}), "");
}
}  // namespace
