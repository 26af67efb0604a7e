// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/ground/estimator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <random>

namespace
{
using namespace traverse;
using ground::Column;
using ground::Seed;
using ground::Verdict;

constexpr geometry::CellRect kWindow{{-150, -150}, {150, 150}};  // 60 x 60 m of 0.2 m cells

/** Columns by cell; a later one replaces an earlier one. */
class Scene
{
 public:
  using Heights = std::function<float(double x_m, double y_m)>;

  /** One surface, its points spread over `span_m`, wherever `where` is true. */
  Scene& put(
      const Heights& height,
      const std::function<bool(double, double)>& where = [](double, double) { return true; },
      float span_m = 0.02F)
  {
    for (int32_t y = kWindow.min.y; y < kWindow.max.y; ++y)
    {
      for (int32_t x = kWindow.min.x; x < kWindow.max.x; ++x)
      {
        const double x_m = lattice_.centre_m(x);
        const double y_m = lattice_.centre_m(y);
        if (where(x_m, y_m))
        {
          const float z = height(x_m, y_m);
          columns_[{x, y}] = {{x, y}, 5, z - span_m / 2, z, z + span_m / 2, z + span_m / 2};
        }
      }
    }
    return *this;
  }

  /** Keeps what a turning scanner's rings, `spacing_m` apart, would meet. */
  Scene& ringsOnly(double spacing_m)
  {
    std::erase_if(
        columns_,
        [&](const auto& entry)
        {
          const auto [x, y] = entry.first;
          const double r = std::hypot(lattice_.centre_m(x), lattice_.centre_m(y));
          return std::fmod(r, spacing_m) > 0.3;
        });
    return *this;
  }

  std::vector<Column> columns() const
  {
    std::vector<Column> all;
    for (const auto& [place, column] : columns_)
    {
      all.push_back(column);
    }
    return all;
  }

  std::vector<Verdict> judge(
      std::vector<Seed> seeds = {{0, 0, 0, 0, 0, 1}}, const ground::Params& params = {}) const
  {
    ground::Estimator estimator;
    const auto verdicts = estimator.estimate(columns(), seeds, lattice_, kWindow, params);
    return {verdicts.begin(), verdicts.end()};
  }

  /** The verdict of the cell at a place. */
  Verdict at(double x_m, double y_m, const std::vector<Verdict>& verdicts) const
  {
    const auto cell = lattice_.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
    const auto found = columns_.find({cell.x, cell.y});
    return found == columns_.end()
               ? Verdict{}
               : verdicts[static_cast<size_t>(std::distance(columns_.begin(), found))];
  }

 private:
  geometry::Lattice lattice_{200};
  std::map<std::pair<int32_t, int32_t>, Column> columns_;
};

float level(double /*x*/, double /*y*/)
{
  return 0;
}

auto box(double x0, double y0, double x1, double y1)
{
  return [=](double x, double y) { return x >= x0 && x < x1 && y >= y0 && y < y1; };
}

TEST(Ground, OfALevelPlaneIsThatPlane)
{
  const Scene scene = Scene().put(level);
  for (const Verdict& v : scene.judge())
  {
    EXPECT_NEAR(v.ground_m, 0, 0.001);
    EXPECT_GT(v.limit_m, 0.01F);  // all of its points
  }
}

TEST(Ground, GoesOnBehindAWall)
{
  const Scene scene =
      Scene().put(level).put([](double, double) { return 1.0F; }, box(5, -30, 5.4, 30), 2.0F);
  const auto verdicts = scene.judge();
  EXPECT_NEAR(scene.at(10.1, 0.1, verdicts).ground_m, 0, 0.01);
  EXPECT_TRUE(scene.at(10.1, 0.1, verdicts).bearsGround());
  EXPECT_LT(scene.at(5.1, 0.1, verdicts).limit_m, 0.06F);  // the wall's foot at most
}

TEST(Ground, IsNotOnTheRoofOfACar)
{
  const Scene scene =
      Scene().put(level).put([](double, double) { return 1.5F; }, box(6, -1, 10.5, 1));
  const auto verdicts = scene.judge();
  EXPECT_FALSE(scene.at(8.1, 0.1, verdicts).bearsGround());
  EXPECT_NEAR(scene.at(8.1, 0.1, verdicts).ground_m, 0, 0.05);
  EXPECT_TRUE(scene.at(12.1, 0.1, verdicts).bearsGround());
}

TEST(Ground, IsNotOnATableThatALowWallHides)
{
  const Scene scene = Scene().put(level).put([](double, double) { return 0.7F; }, box(3, -2, 8, 2));
  EXPECT_FALSE(scene.at(5.1, 0.1, scene.judge()).bearsGround());
}

TEST(Ground, ClimbsAKerbOntoAPavement)
{
  for (const float kerb : {0.12F, 0.25F})
  {
    const Scene scene = Scene().put([kerb](double x, double) { return x < 4 ? 0 : kerb; });
    const auto verdicts = scene.judge();
    EXPECT_TRUE(scene.at(8.1, 0.1, verdicts).bearsGround()) << kerb;
    EXPECT_NEAR(scene.at(8.1, 0.1, verdicts).ground_m, kerb, 0.03) << kerb;
  }
}

TEST(Ground, DoesNotClimbAHedge)
{
  std::mt19937 random(1);
  Scene scene;
  scene.put(level).put(
      [&](double, double) { return 0.4F + 0.001F * static_cast<float>(random() % 100); },
      box(4, -10, 7, 10), 0.3F);
  const auto verdicts = scene.judge();
  const Verdict inside = scene.at(5.5, 0.1, verdicts);
  EXPECT_NEAR(inside.ground_m, 0, 0.1);
  EXPECT_LT(inside.limit_m, 0.15F);
}

TEST(Ground, FollowsSlopesThatTheVehicleTakes)
{
  for (const float slope : {-0.2F, 0.1F, 0.2F})
  {
    const Scene scene = Scene().put(
        [slope](double x, double) { return x < 3 ? 0 : slope * static_cast<float>(x - 3); },
        [](double, double) { return true; }, 0.2F * std::abs(slope));
    const auto verdicts = scene.judge();
    EXPECT_NEAR(scene.at(20.1, 0.1, verdicts).ground_m, slope * 17.1F, 0.03) << slope;
    EXPECT_TRUE(scene.at(20.1, 0.1, verdicts).bearsGround()) << slope;
  }
}

TEST(Ground, CrossesTheGapsBetweenRings)
{
  const Scene scene =
      Scene()
          .put([](double x, double y)
               { return static_cast<float>(0.5 * std::sin(x / 8) * std::cos(y / 8)); })
          .ringsOnly(4);
  size_t known = 0;
  const auto verdicts = scene.judge();
  for (const Verdict& v : verdicts)
  {
    known += v.isKnown() && v.bearsGround() ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(known), 0.99 * static_cast<double>(verdicts.size()));
}

TEST(Ground, IsNotPulledDownByFalseReturnsFromBelow)
{
  std::mt19937 random(2);
  Scene scene;
  scene.put(level).put(
      [](double, double) { return -1.2F; },
      [&](double x, double) { return random() % 100 == 0 && std::abs(x) > 2; });
  const auto verdicts = scene.judge();
  for (const Verdict& v : verdicts)
  {
    EXPECT_NEAR(v.ground_m, 0, 0.03);
  }
}

TEST(Ground, ForgivesAMountHeightThatIsWrongByTwentyCentimetres)
{
  const Scene scene = Scene().put(level);
  for (const float error_m : {-0.2F, 0.2F})
  {
    const auto verdicts = scene.judge({{0, 0, error_m, 0, 0, 1}});
    EXPECT_NEAR(scene.at(10.1, 0.1, verdicts).ground_m, 0, 0.02) << error_m;
    EXPECT_TRUE(scene.at(10.1, 0.1, verdicts).bearsGround()) << error_m;
  }
}

TEST(Ground, IsUnknownWhereNothingLeadsTo)
{
  const Scene scene = Scene().put(level, box(-30, -30, -10, 30)).put(level, box(20, -30, 30, 30));
  ground::Params params;
  params.most_gap_m = 8;
  const auto verdicts = scene.judge({{-20, 0, 0, 0, 0, 1}}, params);
  EXPECT_TRUE(scene.at(-15.1, 0.1, verdicts).isKnown());
  EXPECT_FALSE(scene.at(25.1, 0.1, verdicts).isKnown());
  EXPECT_FALSE(scene.judge({}).front().isKnown()) << "without a seed nothing is";
}

TEST(Ground, HasTheSameBitsInAnyOrder)
{
  std::mt19937 random(3);
  Scene scene;
  scene.put(
      [&](double x, double y)
      {
        return static_cast<float>(
            0.1 * std::sin(x) + 0.02 * static_cast<double>(random() % 7) + 0.05 * y);
      });
  std::vector<Column> columns = scene.columns();
  std::vector<Seed> seeds = {
      {0, 0, 0, 0, 0, 1}, {2.1, 0.3, 0.02F, 0, 0.05F, 1}, {-3.3, 5.1, 0.3F, 0, 0.05F, 1}};
  ground::Estimator estimator;
  const auto bits_of = [&]
  {
    std::map<std::pair<int32_t, int32_t>, std::pair<uint32_t, uint32_t>> bits;
    const auto verdicts =
        estimator.estimate(columns, seeds, geometry::Lattice{200}, kWindow, ground::Params{});
    for (size_t i = 0; i < columns.size(); ++i)
    {
      bits[{columns[i].cell.x, columns[i].cell.y}] = {
          std::bit_cast<uint32_t>(verdicts[i].ground_m),
          std::bit_cast<uint32_t>(verdicts[i].limit_m)};
    }
    return bits;
  };
  const auto first = bits_of();
  std::shuffle(columns.begin(), columns.end(), random);
  std::shuffle(seeds.begin(), seeds.end(), random);
  EXPECT_EQ(bits_of(), first);
}
}  // namespace
