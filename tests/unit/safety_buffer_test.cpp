// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/layers/safety_buffer.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace
{
using namespace traverse;
using namespace traverse::layers;

/** ' ' unknown, '.' free, '#' obstacle, 'v' negative, '~' overhang; as codes. */
std::vector<uint8_t> states(const std::vector<std::string>& picture)
{
  constexpr std::string_view kStates = " .#v~";
  std::vector<uint8_t> all;
  for (const std::string& row : picture)
  {
    for (const char c : row)
    {
      all.push_back(static_cast<uint8_t>(kStates.find(c)));
    }
  }
  return all;
}

using Picture = std::vector<std::string>;

/** ' ' none, 's' soft, 'H' hard, '=' strip. Cells of 1 m. */
Picture buffer(const Picture& picture, double hard_m, double soft_m, StripRule strip)
{
  const size_t columns = picture.front().size();
  const std::vector<uint8_t> zones =
      safetyBuffer(states(picture), static_cast<int32_t>(columns), {1, hard_m, soft_m, strip});
  Picture drawn(picture.size());
  for (size_t i = 0; i < zones.size(); ++i)
  {
    drawn[i / columns].push_back(" sH="[zones[i]]);
  }
  return drawn;
}

TEST(SafetyBuffer, IsHardThenSoftByTheDistanceOfCentres)
{
  EXPECT_EQ(
      buffer(
          {".......",  //
           ".......",  //
           ".......",  //
           "...#...",  //
           ".......",  //
           ".......",  //
           "......."},
          1, 2, StripRule::standard),
      (Picture{
          "   s   ",  //
          " sssss ",  //
          " ssHss ",  //
          "ssHHHss",  //
          " ssHss ",  //
          " sssss ",  //
          "   s   "}));
}

TEST(SafetyBuffer, GrowsFromDitchesButNotFromOverhangsOrTheUnknown)
{
  EXPECT_EQ(
      buffer({".....v....~....  ....  "}, 1, 1, StripRule::none),
      (Picture{"   sHHHs               "}));
}

TEST(SafetyBuffer, LeavesUnknownCellsWithoutZone)
{
  EXPECT_EQ(buffer({"#   .."}, 2, 3, StripRule::none), (Picture{"H   ss"}));
}

TEST(SafetyBuffer, ReachesAWidthOfAWholeNumberOfCells)
{
  const std::vector<uint8_t> row = states({"#..................."});
  const std::vector<uint8_t> zones = safetyBuffer(row, 20, {0.2, 1.8, 1.2, StripRule::none});
  EXPECT_EQ(zones[9], 2) << "1.8 m are 9 cells of 0.2 m";
  EXPECT_EQ(zones[10], 1);
  EXPECT_EQ(zones[15], 1) << "3.0 m are 15";
  EXPECT_EQ(zones[16], 0);
}

const Picture kCorridor = {
    "###########",  //
    "...........",  //
    "...........",  //
    "...........",  //
    "...........",  //
    "...........",  //
    "###########"};

TEST(SafetyBuffer, CutsAStripAlongTheMiddle)
{
  EXPECT_EQ(
      buffer(kCorridor, 1, 4, StripRule::standard),
      (Picture{
          "HHHHHHHHHHH",  //
          "HHHHHHHHHHH",  //
          "sssssssssss",  //
          "===========",  //
          "sssssssssss",  //
          "HHHHHHHHHHH",  //
          "HHHHHHHHHHH"}));
}

TEST(SafetyBuffer, IsWholeWhereNoStripIsAskedFor)
{
  EXPECT_EQ(buffer(kCorridor, 1, 4, StripRule::none)[3], "sssssssssss");
}

TEST(SafetyBuffer, HasNoStripWhereTheVehicleDoesNotFit)
{
  EXPECT_EQ(buffer(kCorridor, 3, 2, StripRule::standard)[3], "HHHHHHHHHHH");
}

TEST(SafetyBuffer, CutsNoUnknownCell)
{
  Picture corridor = kCorridor;
  corridor[3][5] = ' ';
  EXPECT_EQ(buffer(corridor, 1, 4, StripRule::standard)[3], "===== =====");
}

/** The soft zone of two posts reaches past the place where they are opposite each other. */
TEST(SafetyBuffer, LeadsTheStripBetweenPostsIntoTheOpen)
{
  Picture posts(31, std::string(31, '.'));
  posts[8][15] = posts[22][15] = '#';
  const Picture drawn = buffer(posts, 5, 5, StripRule::standard);
  std::string middle;
  for (size_t x = 0; x < 31; ++x)
  {
    middle.push_back(drawn[15][x]);
  }
  EXPECT_EQ(middle, "        ===============        ");
}

TEST(SafetyBuffer, RefusesWhatIsNoGridOrNoWidth)
{
  const std::vector<uint8_t> cells(12);
  EXPECT_THROW(safetyBuffer(cells, 5, {}), std::invalid_argument);
  EXPECT_THROW(safetyBuffer(cells, 0, {}), std::invalid_argument);
  EXPECT_THROW(safetyBuffer(cells, -3, {}), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, -0.1, 1e9, std::numeric_limits<double>::infinity()})
  {
    EXPECT_THROW(safetyBuffer(cells, 4, {.hard_m = bad}), std::invalid_argument) << bad;
    EXPECT_THROW(safetyBuffer(cells, 4, {.soft_m = bad}), std::invalid_argument) << bad;
    EXPECT_THROW(safetyBuffer(cells, 4, {.cell_size_m = bad}), std::invalid_argument) << bad;
  }
  EXPECT_TRUE(safetyBuffer({}, 4, {}).empty());
}

TEST(SafetyBuffer, TakesAnyCodesAndTheSmallestGrids)
{
  const std::vector<uint8_t> cells = {2, 255, 7, 0, 4, 1};
  for (const int32_t columns : {1, 2, 3, 6})
  {
    for (const StripRule strip : {StripRule::standard, StripRule::paper, StripRule::none})
    {
      EXPECT_EQ(safetyBuffer(cells, columns, {.strip = strip}).size(), cells.size());
    }
  }
}
}  // namespace
