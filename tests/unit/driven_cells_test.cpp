// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/driven.h>

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;

constexpr geometry::Lattice kLattice{DrivenCells::kStand_mm};  // a cell is a stand

/** Cells of a square of 40, each with its own height. */
DrivenCells scattered(std::mt19937& random, int count)
{
  DrivenCells driven;
  for (int i = 0; i < count; ++i)
  {
    const auto place = [&] { return static_cast<int32_t>(random() % 40) - 20; };
    const int32_t row = place();
    const int32_t column = place();
    const int64_t z_mm = 100 * row + column;
    driven.add({row, column}, {{z_mm, z_mm}, {0, 0}, {0, 0}});
  }
  return driven;
}

/** By looking at all of them. */
std::vector<double> heightsIn(const DrivenCells& driven, const geometry::CellRect& window)
{
  std::vector<double> heights;
  for (const auto& [place, stand] : driven.cells())
  {
    if (window.contains({place.second, place.first}))
    {
      heights.push_back(static_cast<double>(stand.z_mm.low));
    }
  }
  return heights;
}

TEST(DrivenCells, AreFoundInAWindowAsASweepOverAllFindsThem)
{
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round)
  {
    const DrivenCells driven = scattered(random, static_cast<int>(random() % 200));
    const auto edge = [&] { return static_cast<int32_t>(random() % 60) - 30; };
    const geometry::CellIndex min{edge(), edge()};
    const auto side = static_cast<int32_t>(random() % 30);
    const geometry::CellRect window{min, {min.x + side, min.y + side}};
    const std::vector<double> expected = heightsIn(driven, window);

    std::vector<ground::Seed> seeds;
    driven.seedsIn(window, kLattice, 0, seeds);
    ASSERT_EQ(seeds.size(), expected.size()) << "round " << round;
    for (size_t i = 0; i < seeds.size(); ++i)
    {
      ASSERT_FLOAT_EQ(seeds[i].z_m, static_cast<float>(expected[i] / 1000));
    }
    ASSERT_EQ(
        driven.referenceIn(window, kLattice), expected.empty() ? 0 : std::llround(expected[0]));
  }
}
}  // namespace
