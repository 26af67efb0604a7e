// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#include <traverse/traversability_grid/features.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;

using PointsMm = std::vector<std::array<int64_t, 3>>;

int64_t below(std::mt19937& random, int64_t end)
{
  return static_cast<int64_t>(random()) % end;
}

/** The column of one cell, with points relative to its corner. */
struct Column
{
  layers::HeightSlabs slabs;
  int32_t head = layers::HeightSlabs::kNone;

  explicit Column(const PointsMm& points, int32_t slab_mm = 500)
  {
    for (const auto& [x, y, z] : points)
    {
      slabs.obtain(head, static_cast<int32_t>(geometry::floorDiv(z, slab_mm)))
          ->add(
              {static_cast<uint16_t>(x), static_cast<uint16_t>(y),
               static_cast<uint16_t>(geometry::floorMod(z, slab_mm))},
              7);
    }
  }

  Features features(const SlabReading& reading = {}) const
  {
    return featuresOf(slabs, slabs.get(head), reading);
  }
};

/** The formulas as the paper writes them: two passes over the points, in double precision. */
Features reference(const PointsMm& points)
{
  Features f;
  f.n = points.size();
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd rows(n, 3);
  Eigen::VectorXd z(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const auto& [x_mm, y_mm, z_mm] = points[static_cast<size_t>(i)];
    rows.row(i) << 1e-3 * static_cast<double>(x_mm), 1e-3 * static_cast<double>(y_mm), 1;
    z(i) = 1e-3 * static_cast<double>(z_mm);
  }
  f.mean_m = z.mean();
  f.min_m = z.minCoeff();
  f.max_m = z.maxCoeff();
  f.deviation_m = (z.array() - f.mean_m).abs().maxCoeff();
  f.variance_m2 = (z.array() - f.mean_m).square().mean();
  const Eigen::Vector3d plane = rows.colPivHouseholderQr().solve(z);
  f.slope_x = plane.x();
  f.slope_y = plane.y();
  f.at_corner_m = plane.z();
  return f;
}

TEST(Features, AreThoseOfTheNaiveFormulas)
{
  std::mt19937 random(11);
  for (int round = 0; round < 500; ++round)
  {
    PointsMm points;
    const auto base = below(random, 200'000) - 100'000;
    const int64_t n = 3 + below(random, 60);
    for (int64_t i = 0; i < n; ++i)
    {
      points.push_back({below(random, 200), below(random, 200), base + below(random, 1900)});
    }
    const Features ours = Column(points).features();
    const Features naive = reference(points);
    ASSERT_EQ(ours.n, naive.n);
    EXPECT_NEAR(ours.min_m, naive.min_m, 1e-11);
    // The sums are exact; what remains is rounding of doubles at 100 m: some 1e-14 m.
    EXPECT_NEAR(ours.mean_m, naive.mean_m, 1e-11);
    EXPECT_NEAR(ours.max_m, naive.max_m, 1e-11);
    EXPECT_NEAR(ours.deviation_m, naive.deviation_m, 1e-11);
    EXPECT_NEAR(ours.variance_m2, naive.variance_m2, 1e-11);
    if (ours.has_plane && std::hypot(naive.slope_x, naive.slope_y) < 1e3)
    {
      EXPECT_NEAR(ours.slope_x, naive.slope_x, 1e-7 * (1 + std::abs(naive.slope_x)));
      EXPECT_NEAR(ours.slope_y, naive.slope_y, 1e-7 * (1 + std::abs(naive.slope_y)));
      EXPECT_NEAR(
          ours.at_corner_m, naive.at_corner_m,
          1e-7 * (1 + std::hypot(naive.slope_x, naive.slope_y)));
    }
  }
}

TEST(Features, DoNotDependOnWhereSlabsBegin)
{
  std::mt19937 random(12);
  PointsMm points;
  for (int i = 0; i < 40; ++i)
  {
    points.push_back({below(random, 200), below(random, 200), below(random, 1200) - 700});
  }
  SlabReading coarse;
  SlabReading fine;
  fine.slab_mm = 130;
  const Features a = Column(points, coarse.slab_mm).features(coarse);
  const Features b = Column(points, fine.slab_mm).features(fine);
  EXPECT_EQ(a.n, b.n);
  EXPECT_NEAR(a.mean_m, b.mean_m, 1e-12);
  EXPECT_NEAR(a.variance_m2, b.variance_m2, 1e-12);
  EXPECT_NEAR(a.slope_x, b.slope_x, 1e-9);
}

TEST(Features, SlopeOfAPlaneIsItsAngle)
{
  PointsMm points;
  for (int64_t x = 0; x < 200; x += 40)
  {
    for (int64_t y = 0; y < 200; y += 40)
    {
      points.push_back({x, y, 1000 + x});
    }
  }
  const Features f = Column(points).features();
  EXPECT_TRUE(f.has_plane);
  EXPECT_NEAR(f.slope_deg(), 45, 1e-9);
  EXPECT_NEAR(f.at_corner_m, 1.0, 1e-9);
}

TEST(Features, PointsOnALineHaveNoPlane)
{
  const Features f = Column({{10, 20, 0}, {20, 40, 5}, {30, 60, 90}, {40, 80, 100}}).features();
  EXPECT_FALSE(f.has_plane);
  EXPECT_TRUE(std::isnan(f.slope_deg()));
  EXPECT_FALSE(Column({{5, 5, 0}, {5, 5, 1}, {5, 5, 2}}).features().has_plane);
}

TEST(Features, StopAtTheFirstGapThatTheVehicleFitsUnder)
{
  const PointsMm points = {{10, 10, 0}, {20, 20, 1900}, {30, 30, 3899}, {40, 40, 5899}};
  const Features f = Column(points).features();
  EXPECT_EQ(f.n, 3U);
  EXPECT_NEAR(f.max_m, 3.899, 1e-12) << "1.999 m is too low for a vehicle of 2 m, 2.000 m is not";
}

TEST(Classifier, GivesTheFirstClassWhoseLimitsHold)
{
  const Params params;
  const Classifier classify(params);
  Features f;
  f.n = 10;
  f.has_plane = true;
  EXPECT_EQ(classify(f), Class::flat);
  f.deviation_m = 0.05;
  EXPECT_EQ(classify(f), Class::small_roughness);
  f.slope_x = std::tan(50 * std::numbers::pi / 180);
  EXPECT_EQ(classify(f), Class::large_roughness);
  f.variance_m2 = 0.02;
  EXPECT_EQ(classify(f), Class::obstacle);
  f.n = 2;
  EXPECT_EQ(classify(f), Class::undefined);
}

TEST(Classifier, WhatLiesOnALimitIsWithin)
{
  Params params;
  params.flat.slope_deg = 45;
  params.small_roughness.slope_deg = 45;
  const Classifier classify(params);
  // Mean height 30 mm with points at 0 and 60 mm; a plane of exactly 45 degrees.
  const Features level = Column({{0, 0, 0}, {9, 0, 60}, {0, 9, 0}, {9, 9, 60}}).features();
  EXPECT_EQ(level.deviation_m, 0.03);
  const Features steep = Column({{0, 0, 0}, {9, 0, 9}, {0, 9, 0}, {9, 9, 9}}).features();
  EXPECT_EQ(classify(steep), Class::flat);
}

TEST(Classifier, OfThePaperIsSureOfObstaclesOnlyWithoutAPlane)
{
  Params paper;
  paper.classifier = ClassifierKind::paper;
  const Classifier classify(paper);
  Features f;
  f.n = 3;
  f.has_plane = false;
  EXPECT_EQ(classify(f), Class::undefined);
  f.deviation_m = 0.2;
  EXPECT_EQ(classify(f), Class::undefined);
  f.deviation_m = 0.3;
  EXPECT_EQ(classify(f), Class::obstacle);
}

TEST(Index, IsTheClassesAndHundredForObstacles)
{
  Params params;
  params.index_flat = 5;
  EXPECT_EQ(indexOf(Class::flat, params), 5);
  EXPECT_EQ(indexOf(Class::obstacle, params), 100);
  EXPECT_EQ(indexOf(Class::undefined, params), 255);
}
}  // namespace
