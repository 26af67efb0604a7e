// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/departures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{
using namespace traverse;
using namespace traverse::evaluation;

constexpr geometry::Lattice kMetres{1000};
constexpr geometry::CellRect kWindow{{0, 0}, {10, 4}};

/** A square of 0.2 m in the middle of cell (x, 1). */
Polygon squareIn(int x)
{
  const double mid = x + 0.5;
  return {{mid - 0.1, 1.4}, {mid + 0.1, 1.4}, {mid + 0.1, 1.6}, {mid - 0.1, 1.6}};
}

TEST(Departures, AreWhenACellIsLeft)
{
  const std::vector<MovingFrame> frames = {
      {10, {squareIn(2)}}, {11, {squareIn(2)}}, {12, {squareIn(6)}}};
  const std::vector<Departure> all = departuresOf(frames, kMetres, kWindow);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].cell.x, 2);
  EXPECT_EQ(all[0].cell.y, 1);
  EXPECT_EQ(all[0].left_s, 12);
  EXPECT_TRUE(std::isinf(all[0].again_s));
}

TEST(Departures, KnowWhenSomethingComesAgain)
{
  const std::vector<MovingFrame> frames = {
      {0, {squareIn(2)}}, {1, {}}, {2, {}}, {3, {squareIn(2)}}, {4, {squareIn(8)}}};
  const std::vector<Departure> all = departuresOf(frames, kMetres, kWindow);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].left_s, 1);
  EXPECT_EQ(all[0].again_s, 3);
  EXPECT_EQ(all[1].left_s, 4);
}

TEST(Departures, OfOneThingAreNoneWhereAnotherStands)
{
  const std::vector<MovingFrame> frames = {
      {0, {squareIn(2), squareIn(2)}}, {1, {squareIn(2), squareIn(5)}}};
  EXPECT_TRUE(departuresOf(frames, kMetres, kWindow).empty());
}

TEST(Departures, OutsideTheWindowAreNotTold)
{
  const std::vector<MovingFrame> frames = {
      {0, {squareIn(-1), squareIn(10), {{-1e8, -1e8}, {-1e8, -2e8}, {-2e8, -1e8}}}}, {1, {}}};
  EXPECT_TRUE(departuresOf(frames, kMetres, kWindow).empty());
}

TEST(Departures, OfNoAreaAreNone)
{
  EXPECT_TRUE(departuresOf({{0, {Polygon(3, {2.5, 1.5})}}, {1, {}}}, kMetres, kWindow).empty());
}

TEST(Departures, TakeBoundedTime)
{
  const geometry::CellRect wide{{0, 0}, {5000, 5000}};
  Polygon detailed(1000, {-1e8, -1e8});
  detailed.push_back({1e8, 1e8});
  detailed.push_back({1e8, -1e8});
  EXPECT_THROW(departuresOf({{0, {detailed}}}, kMetres, wide), std::length_error);
  // not too many edges to look at, but too many cells to keep as well
  const Polygon all = {{-1e4, -1e4}, {0, -1e4}, {1e4, -1e4}, {1e4, 0},
                       {1e4, 1e4},   {0, 1e4},  {-1e4, 1e4}};
  EXPECT_THROW(departuresOf({{0, {all}}}, kMetres, wide), std::length_error);
}

TEST(Departures, TimesMustGrow)
{
  EXPECT_THROW(departuresOf({{1, {}}, {1, {}}}, kMetres, kWindow), std::invalid_argument);
}
}  // namespace
