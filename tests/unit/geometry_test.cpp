// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>

#include <gtest/gtest.h>

namespace
{
using namespace traverse::geometry;

TEST(Lattice, FloorDivisionRoundsDown)
{
  EXPECT_EQ(floorDiv(-1, 200), -1);
  EXPECT_EQ(floorDiv(-200, 200), -1);
  EXPECT_EQ(floorDiv(-201, 200), -2);
  EXPECT_EQ(floorDiv(199, 200), 0);
  EXPECT_EQ(floorMod(-1, 200), 199);
}

TEST(Lattice, CellsAreHalfOpenAndStartAtTheSmallestCorner)
{
  const Lattice lattice{200};
  EXPECT_EQ(lattice.cellOf(toMillimetres(0.0), toMillimetres(0.199)), (CellIndex{0, 0}));
  EXPECT_EQ(lattice.cellOf(toMillimetres(0.2), toMillimetres(-0.001)), (CellIndex{1, -1}));
  EXPECT_DOUBLE_EQ(lattice.edge_m(-1), -0.2);
  EXPECT_DOUBLE_EQ(lattice.centre_m(0), 0.1);
}

TEST(Lattice, IsExactTenThousandKilometresOut)
{
  const Lattice lattice{200};
  EXPECT_EQ(lattice.cellOf(toMillimetres(1e7 + 0.19), 0).x, 50'000'000);
  EXPECT_EQ(lattice.cellOf(toMillimetres(-1e7 - 0.01), 0).x, -50'000'001);
  EXPECT_DOUBLE_EQ(lattice.edge_m(50'000'001), 1e7 + 0.2);
}

TEST(CellRect, IsHalfOpen)
{
  const CellRect rect{{-2, 0}, {3, 4}};
  EXPECT_EQ(rect.width(), 5);
  EXPECT_EQ(rect.height(), 4);
  EXPECT_TRUE(rect.contains({-2, 0}));
  EXPECT_FALSE(rect.contains({3, 0}));
  EXPECT_TRUE(CellRect{}.empty());
}
}  // namespace
