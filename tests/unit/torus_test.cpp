// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/torus.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

namespace
{
using namespace traverse::geometry;

constexpr int32_t kFar = std::numeric_limits<int32_t>::max() - (1 << 15);

TEST(Torus, StoresACellAtTheRemaindersOfItsIndices)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int32_t> any(
      std::numeric_limits<int32_t>::min(), std::numeric_limits<int32_t>::max());
  for (const int32_t edge : {1, 2, 500, 750, 5000})
  {
    const Torus torus(edge);
    for (int i = 0; i < 2000; ++i)
    {
      const CellIndex cell = {any(random), any(random)};
      const int64_t column = floorMod(cell.x, torus.side());
      const int64_t row = floorMod(cell.y, torus.side());
      ASSERT_EQ(torus.indexOf(cell), static_cast<size_t>(row * torus.side() + column))
          << edge << ": " << cell.x << ", " << cell.y;
      ASSERT_EQ(torus.runFrom(cell.x), torus.side() - column);
    }
  }
}

/** The paper's floor(rem(x, W dx) / dx) in doubles has column W at x = -1e-15 m. */
TEST(Torus, HasThePapersCellForPlacesJustBelowZero)
{
  const Torus torus(300);
  const Lattice lattice;
  const CellIndex cell = lattice.cellOf(toMillimetres(-1e-15), toMillimetres(-0.001));
  EXPECT_EQ(torus.indexOf(cell), static_cast<size_t>(torus.side() - 1) * torus.side());
}

TEST(Torus, HoldsTheRegionTurned)
{
  for (const int32_t edge : {1, 2, 3, 5, 11, 12, 181, 182, 500, 724, 725, 750, 4096, 11585, 16384})
  {
    const int64_t side = Torus(edge).side();
    EXPECT_GT(side * side, 2LL * edge * edge) << edge;
    EXPECT_LE(side * side, 8LL * edge * edge) << edge << ": twice as wide as need be";
    EXPECT_EQ(side & (side - 1), 0) << edge;
  }
}

TEST(Torus, RefusesEdgesThatAreNone)
{
  for (const int32_t edge : {0, -1, std::numeric_limits<int32_t>::min(), Torus::kLargestSide + 1})
  {
    EXPECT_THROW(Torus{edge}, std::invalid_argument) << edge;
    EXPECT_THROW(RollingRegion{edge}, std::invalid_argument) << edge;
  }
}

TEST(RollingRegion, RefusesPlacesBeyondTheIndices)
{
  RollingRegion region(Torus::kLargestSide);
  const CellRect before = region.rect();
  for (const CellIndex far :
       {CellIndex{kFar + 1, 0}, {-kFar - 1, 0}, {0, kFar + 1}, {0, -kFar - 1}})
  {
    EXPECT_THROW(region.moveTo(far), std::invalid_argument) << far.x << ", " << far.y;
  }
  EXPECT_EQ(region.rect(), before);
}

TEST(RollingRegion, GoesFromOneEndOfTheIndicesToTheOther)
{
  RollingRegion region(Torus::kLargestSide);
  region.moveTo({kFar, kFar});
  const CellRect before = region.rect();
  const DroppedCells dropped = region.moveTo({-kFar, -kFar});
  ASSERT_EQ(dropped.rects().size(), 1U);
  EXPECT_EQ(dropped.rects()[0], before);
}

int64_t areaOf(const CellRect& r)
{
  return int64_t{r.width()} * r.height();
}

/** True where a cell belongs to one of the rects, or to none, as it should. */
void expectDropped(const CellRect& old, const CellRect& now, const DroppedCells& dropped)
{
  int64_t area = 0;
  for (const CellRect& rect : dropped.rects())
  {
    EXPECT_FALSE(rect.empty());
    area += areaOf(rect);
  }
  int64_t left = 0;
  for (int32_t y = old.min.y; y < old.max.y; ++y)
  {
    for (int32_t x = old.min.x; x < old.max.x; ++x)
    {
      int in = 0;
      for (const CellRect& rect : dropped.rects())
      {
        in += rect.contains({x, y}) ? 1 : 0;
      }
      ASSERT_EQ(in, now.contains({x, y}) ? 0 : 1) << x << ", " << y;
      left += in;
    }
  }
  EXPECT_EQ(area, left) << "rects reach outside the region";
}

TEST(RollingRegion, DropsWhatLeavesAndEachCellOnce)
{
  for (const int32_t edge : {1, 2, 5, 8})
  {
    for (int32_t dy = -edge - 2; dy <= edge + 2; ++dy)
    {
      for (int32_t dx = -edge - 2; dx <= edge + 2; ++dx)
      {
        RollingRegion region(edge);
        region.moveTo({-450'000'000, 499'999'999});
        const CellRect old = region.rect();
        const DroppedCells dropped = region.moveTo({-450'000'000 + dx, 499'999'999 + dy});
        expectDropped(old, region.rect(), dropped);
      }
    }
  }
}

TEST(RollingRegion, HasItsCentreInTheMiddle)
{
  RollingRegion region(5);
  region.moveTo({-100, 200});
  EXPECT_EQ(region.rect(), (CellRect{{-102, 198}, {-97, 203}}));
  RollingRegion even(4);
  even.moveTo({-100, 200});
  EXPECT_EQ(even.rect(), (CellRect{{-102, 198}, {-98, 202}}));
}
}  // namespace
