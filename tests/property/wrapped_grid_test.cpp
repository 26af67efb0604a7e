// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// After any moves a torus holds what a grid without borders would hold in the same region.
#include <traverse/layers/wrapped_grid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <tuple>
#include <vector>

namespace
{
using traverse::geometry::CellIndex;
using traverse::geometry::CellRect;
using traverse::layers::WrappedGrid;

/** Row by row, by growing x. */
struct ByRow
{
  bool operator()(CellIndex a, CellIndex b) const
  {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  }
};

using Sparse = std::map<CellIndex, uint32_t, ByRow>;  // cells that are not 0
using Listed = std::vector<std::pair<CellIndex, uint32_t>>;

/** A wrapped grid beside a map of cells that knows no borders, moved and written alike. */
class Pair
{
 public:
  Pair(int32_t edge, uint32_t seed) : edge_(edge), grid_(edge), random_(seed) {}

  void write(int times)
  {
    for (int i = 0; i < times; ++i)
    {
      const CellRect& r = grid_.region();
      const CellIndex cell = {between(r.min.x, r.max.x - 1), between(r.min.y, r.max.y - 1)};
      grid_.at(cell) = sparse_[cell] = static_cast<uint32_t>(random_());
    }
  }

  /** A part filled with one value, as beams do. */
  void fill()
  {
    const CellRect& r = grid_.region();
    CellRect part = {{between(r.min.x, r.max.x), between(r.min.y, r.max.y)}, r.max};
    part.max = {between(part.min.x, r.max.x), between(part.min.y, r.max.y)};
    grid_.fill(part, 7);
    for (int32_t y = part.min.y; y < part.max.y; ++y)
    {
      for (int32_t x = part.min.x; x < part.max.x; ++x)
      {
        sparse_[{x, y}] = 7;
      }
    }
  }

  /** Checks what leaves against the map's cells outside the new region. */
  void moveTo(CellIndex centre)
  {
    const CellRect old = grid_.region();
    Sparse left;
    size_t calls = 0;
    grid_.moveTo(
        centre,
        [&](CellIndex cell, uint32_t value)
        {
          ++calls;
          EXPECT_TRUE(old.contains(cell));
          EXPECT_FALSE(grid_.region().contains(cell));
          if (value != 0)
          {
            EXPECT_TRUE(left.emplace(cell, value).second) << "left twice";
          }
        });
    EXPECT_EQ(calls, cellsOnlyIn(old));
    EXPECT_EQ(left, forgetOutside());
  }

  void moveSilentlyTo(CellIndex centre)
  {
    grid_.moveTo(centre);
    forgetOutside();
  }

  void expectSame() const
  {
    const CellRect& region = grid_.region();
    Listed expected;
    for (int32_t y = region.min.y; y < region.max.y; ++y)
    {
      for (int32_t x = region.min.x; x < region.max.x; ++x)
      {
        const auto found = sparse_.find({x, y});
        expected.push_back({{x, y}, found == sparse_.end() ? 0 : found->second});
      }
    }
    Listed seen;
    grid_.forEach([&](CellIndex cell, uint32_t value) { seen.push_back({cell, value}); });
    EXPECT_TRUE(seen == expected) << "at " << region.min.x << ", " << region.min.y;
  }

  /** Mostly a few cells, now and then across half of the region, the whole, or far away. */
  CellIndex nextCentre(CellIndex last)
  {
    const int kind = between(0, 9);
    const int32_t reach = kind < 6 ? 3 : kind < 8 ? edge_ : 3 * edge_;
    if (kind == 9 && between(0, 3) == 0)
    {
      return farPlace();
    }
    return {last.x + between(-reach, reach), last.y + between(-reach, reach)};
  }

  /** Within 1e7 m of zero, in cells of 2 cm. */
  CellIndex farPlace()
  {
    return {between(-500'000'000, 500'000'000), between(-500'000'000, 500'000'000)};
  }

  int32_t between(int32_t a, int32_t b) { return std::uniform_int_distribution(a, b)(random_); }

 private:
  size_t cellsOnlyIn(const CellRect& old) const
  {
    const CellRect& now = grid_.region();
    const auto overlap = [&](int32_t a, int32_t b)
    { return static_cast<size_t>(std::max<int64_t>(0, edge_ - std::abs(int64_t{a} - b))); };
    const auto edge = static_cast<size_t>(edge_);
    return edge * edge - overlap(old.min.x, now.min.x) * overlap(old.min.y, now.min.y);
  }

  Sparse forgetOutside()
  {
    Sparse left;
    for (auto it = sparse_.begin(); it != sparse_.end();)
    {
      if (grid_.region().contains(it->first))
      {
        ++it;
        continue;
      }
      if (it->second != 0)
      {
        left.insert(*it);
      }
      it = sparse_.erase(it);
    }
    return left;
  }

  int32_t edge_;
  WrappedGrid<uint32_t> grid_;
  Sparse sparse_;
  std::mt19937 random_;
};

class WrappedGridMoves : public ::testing::TestWithParam<uint32_t>
{
};

TEST_P(WrappedGridMoves, EqualAGridWithoutBorders)
{
  const uint32_t seed = GetParam();
  std::mt19937 random(seed);
  const int32_t edge = std::uniform_int_distribution(1, 45)(random);
  Pair pair(edge, seed);
  CellIndex centre = seed % 2 == 0 ? CellIndex{} : pair.farPlace();
  for (int step = 0; step < 60; ++step)
  {
    pair.write(pair.between(0, 60));
    if (step % 7 == 0)
    {
      pair.fill();
    }
    centre = pair.nextCentre(centre);
    if (step % 3 == 0)
    {
      pair.moveSilentlyTo(centre);
    }
    else
    {
      pair.moveTo(centre);
    }
    pair.expectSame();
    ASSERT_FALSE(HasFailure()) << "seed " << seed << ", step " << step;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, WrappedGridMoves, ::testing::Range(1U, 41U));

TEST(WrappedGrid, KnowsOnlyItsRegion)
{
  WrappedGrid<int> grid(4);
  grid.at({1, 1}) = 5;
  EXPECT_EQ(*grid.get({1, 1}), 5);
  EXPECT_EQ(grid.get({2, 1}), nullptr);
  EXPECT_EQ(grid.get({-3, 0}), nullptr);
  grid.clear();
  EXPECT_EQ(*grid.get({1, 1}), 0);
}

TEST(WrappedGrid, IsEmptyWhereItComesBackTo)
{
  WrappedGrid<int> grid(4);
  grid.at({1, 1}) = 5;
  grid.moveTo({4, 0});
  grid.moveTo({0, 0});
  grid.forEach([](CellIndex, int value) { EXPECT_EQ(value, 0); });
}
}  // namespace
