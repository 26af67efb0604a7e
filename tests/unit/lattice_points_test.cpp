// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#include <traverse/traversability_grid/lattice_points.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;

/** 4 x 4 km around (1e6 m, -2e6 m), heights -500..500 m, in the frame of the map. */
LatticeBox farBox()
{
  LatticeBox box;
  box.T_map_base = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  box.min_x_mm = 999'998'000;
  box.min_y_mm = -2'000'002'000;
  box.width_mm = box.height_mm = 4'000;
  box.lowest_m = -500;
  box.highest_m = 500;
  box.bottom_level = -1000;
  box.bottom_mm = -500'000;
  box.depth_mm = 1'000'001;
  return box;
}

/** A box around the map's zero, reaching well over it. */
LatticeBox nearBox()
{
  LatticeBox box = farBox();
  box.min_x_mm = box.min_y_mm = -75'000;
  box.width_mm = box.height_mm = 150'000;
  return box;
}

struct Cloud
{
  std::vector<float> x, y, z;

  void add(double px, double py, double pz)
  {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
};

LatticePoints onLattice(const LatticeBox& box, const Cloud& cloud)
{
  LatticePoints points;
  toLattice(box, cloud.x.data(), cloud.y.data(), cloud.z.data(), cloud.x.size(), points);
  return points;
}

/** One point the slow way; false where it is not inside. */
bool expectPoint(const LatticeBox& box, const Cloud& cloud, const LatticePoints& points, size_t i)
{
  const auto& T = box.T_map_base;
  std::array<double, 3> p{};
  for (size_t k = 0; k < 3; ++k)
  {
    p[k] = T[k][0] * double{cloud.x[i]} + T[k][1] * double{cloud.y[i]} +
           T[k][2] * double{cloud.z[i]} + T[k][3];
  }
  const int64_t x = geometry::toMillimetres(p[0]) - static_cast<int64_t>(box.min_x_mm);
  const int64_t y = geometry::toMillimetres(p[1]) - static_cast<int64_t>(box.min_y_mm);
  const int64_t z = geometry::toMillimetres(p[2]);
  const bool is_inside = x >= 0 && x < static_cast<int64_t>(box.width_mm) && y >= 0 &&
                         y < static_cast<int64_t>(box.height_mm) && p[2] >= box.lowest_m &&
                         p[2] <= box.highest_m;
  EXPECT_EQ(points.column[i], is_inside ? x / box.cell_mm : -1) << p[0];
  if (is_inside)
  {
    EXPECT_EQ(points.row[i], y / box.cell_mm) << p[1];
    EXPECT_EQ(points.level[i], geometry::floorDiv(z, box.slab_mm)) << p[2];
    EXPECT_EQ(points.x_mm[i], x % box.cell_mm) << p[0];
    EXPECT_EQ(points.y_mm[i], y % box.cell_mm) << p[1];
    EXPECT_EQ(points.z_mm[i], geometry::floorMod(z, box.slab_mm)) << p[2];
  }
  return is_inside;
}

TEST(LatticePoints, AreRoundedAsToMillimetresRounds)
{
  // Sixteenths of a metre are 62.5 mm: every second one is a half, below zero and above; so are
  // their neighbours' distances from one, as small as floats allow.
  Cloud cloud;
  for (int i = -250; i < 250; ++i)
  {
    const auto half = static_cast<float>(i) / 16;
    const float up = std::nextafter(half, 100.F);
    cloud.add(half, up, -half);
  }
  const LatticeBox box = nearBox();
  const LatticePoints points = onLattice(box, cloud);
  for (size_t i = 0; i < points.size; ++i)
  {
    ASSERT_TRUE(expectPoint(box, cloud, points, i));
  }
}

TEST(LatticePoints, HalvesGoAwayFromZero)
{
  Cloud cloud;
  cloud.add(0.0625, -0.0625, 0.1875);
  cloud.add(std::nextafter(0.0625F, 0.F), std::nextafter(-0.0625F, 0.F), -0.1875);
  const LatticePoints points = onLattice(nearBox(), cloud);
  EXPECT_EQ(points.x_mm[0], 63);
  EXPECT_EQ(points.y_mm[0], 200 - 63);
  EXPECT_EQ(points.z_mm[0], 188);
  EXPECT_EQ(points.x_mm[1], 62);
  EXPECT_EQ(points.y_mm[1], 200 - 62);
  EXPECT_EQ(points.z_mm[1], 500 - 188);
}

TEST(LatticePoints, AreThoseOfTheSlowWayAtAnyPoseAndCellSize)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  size_t inside = 0;
  for (int round = 0; round < 200; ++round)
  {
    LatticeBox box = round % 2 == 0 ? nearBox() : farBox();
    box.cell_mm = 1 + static_cast<int32_t>(random() % 10'000);
    box.slab_mm = 20 + static_cast<int32_t>(random() % 4'980);
    box.bottom_level = static_cast<int32_t>(geometry::floorDiv(-500'000, box.slab_mm));
    box.bottom_mm = static_cast<double>(box.bottom_level) * box.slab_mm;
    for (auto& row : box.T_map_base)
    {
      row = {any(random), any(random), any(random), 0};
    }
    box.T_map_base[0][3] = (box.min_x_mm + box.width_mm / 2) / 1000 + any(random);
    box.T_map_base[1][3] = (box.min_y_mm + box.height_mm / 2) / 1000 + any(random);
    Cloud cloud;
    const size_t size = 1 + random() % LatticePoints::kMost;
    for (size_t i = 0; i < size; ++i)
    {
      cloud.add(3 * any(random), 3 * any(random), 3 * any(random));
    }
    const LatticePoints points = onLattice(box, cloud);
    size_t here = 0;
    for (size_t i = 0; i < points.size; ++i)
    {
      here += expectPoint(box, cloud, points, i) ? 1 : 0;
    }
    ASSERT_EQ(points.outside, points.size - here);
    inside += here;
  }
  EXPECT_GT(inside, 20'000U) << "there is something to compare";
}

TEST(LatticePoints, ThatAreNoneAreBadAndThoseElsewhereOutside)
{
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  Cloud cloud;
  for (const float bad : {kNan, kInf, -kInf, kMax, -kMax, 1.1e8F})
  {
    cloud.add(bad, 0, 0);
    cloud.add(0, bad, 0);
    cloud.add(0, 0, bad);
  }
  for (const float outside : {9e7F, -9e7F, 1e5F})
  {
    cloud.add(outside, 0, 0);
    cloud.add(0, outside, 0);
    cloud.add(0, 0, outside);
  }
  cloud.add(1, 2, 3);
  const LatticePoints points = onLattice(nearBox(), cloud);
  EXPECT_EQ(points.bad, 18U);
  EXPECT_EQ(points.outside, 9U);
  for (size_t i = 0; i + 1 < points.size; ++i)
  {
    EXPECT_EQ(points.column[i], -1);
  }
  EXPECT_EQ(points.column[points.size - 1], 76'000 / 200);
}

TEST(LatticePoints, ABoxOfNoWidthHoldsNothing)
{
  LatticeBox box = nearBox();
  box.width_mm = 0;
  Cloud cloud;
  cloud.add(-75, 0, 0);
  const LatticePoints points = onLattice(box, cloud);
  EXPECT_EQ(points.column[0], -1);
  EXPECT_EQ(points.outside, 1U);
}
}  // namespace
