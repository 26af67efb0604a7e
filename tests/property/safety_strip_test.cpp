// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Where strips are and where they are not: straight, bent and ragged corridors in all directions,
// and single obstacles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <support/buffer_scenes.h>
#include <support/single_obstacles.h>
#include <vector>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using layers::BufferParams;
using layers::StripRule;

constexpr int32_t kEdge = 180;
constexpr Place kMiddle = {90.3, 89.8};

BufferParams with(double hard_m, double soft_m)
{
  return {0.2, hard_m, soft_m, StripRule::standard};
}

constexpr auto kNone = static_cast<uint8_t>(layers::BufferZone::none);
constexpr auto kStrip = static_cast<uint8_t>(layers::BufferZone::strip);

/** What of a corridor's strip holds. */
struct Seen
{
  bool is_whole = false;       //!< by the cells' sides, from one end of the walls to the other
  bool leads_through = false;  //!< from open space to open space
  double farthest_off = 0;     //!< cells from the middle line, within the corridor
  size_t cells = 0;
};

/** From one end to the other over strip and open cells, but not round the walls. */
Seen lookAlong(const BufferScene& scene, const Corridor& corridor, const BufferParams& params)
{
  const std::vector<uint8_t> zones = scene.buffer(params);
  std::vector<bool> passable(zones.size());
  std::vector<bool> is_strip(zones.size());
  std::pair<double, size_t> first = {1e9, 0};
  std::pair<double, size_t> last = {-1e9, 0};
  Seen seen;
  for (int32_t y = 0; y < kEdge; ++y)
  {
    for (int32_t x = 0; x < kEdge; ++x)
    {
      const Place p = corridor.along({x + 0.5, y + 0.5});
      const uint8_t zone = zones[scene.index(x, y)];
      passable[scene.index(x, y)] =
          (zone == kStrip || zone == kNone) && std::abs(p.y) <= corridor.width / 2;
      if (zone == kStrip && std::abs(p.x) <= corridor.length / 2)
      {
        ++seen.cells;
        is_strip[scene.index(x, y)] = true;
        first = std::min(first, {p.x, scene.index(x, y)});
        last = std::max(last, {p.x, scene.index(x, y)});
        seen.farthest_off = std::max(seen.farthest_off, std::abs(p.y));
      }
    }
  }
  const geometry::SinCos turn = geometry::sinCosOf(corridor.angle_deg * geometry::kPi / 180);
  const auto at = [&](double d)
  {
    return scene.index(
        static_cast<int32_t>(corridor.middle.x + d * turn.cos),
        static_cast<int32_t>(corridor.middle.y + d * turn.sin));
  };
  const double open = corridor.length / 2 + 25;
  // The open itself may hang together by corners where the buffers of both walls part.
  seen.leads_through = Reach(passable, kEdge, at(-open), 8).has(at(open));
  seen.is_whole = last.first - first.first > corridor.length - 3 &&
                  Reach(is_strip, kEdge, first.second, 4).has(last.second);
  return seen;
}

struct Widths
{
  double hard_m, soft_m;
  double more;  // than twice hard_m, cells
};

class StraightCorridors : public ::testing::TestWithParam<Widths>
{
};

// A wall falls on cells to half a diagonal, the strip's own cells are within 0.84 of the bisector.
constexpr double kOff_cells = 1.25;

TEST_P(StraightCorridors, HaveAStripInEveryDirection)
{
  const auto [hard_m, soft_m, more] = GetParam();
  for (int angle = 0; angle < 180; angle += 5)
  {
    Corridor corridor{kMiddle, static_cast<double>(angle)};
    corridor.width = 2 * hard_m / 0.2 + more;
    corridor.length = 80;
    BufferScene scene(kEdge);
    scene.add([&](Place p) { return corridor.isWall(p); });
    const Seen seen = lookAlong(scene, corridor, with(hard_m, soft_m));
    EXPECT_TRUE(seen.is_whole) << angle;
    EXPECT_TRUE(seen.leads_through) << angle;
    EXPECT_LE(seen.farthest_off, kOff_cells) << angle;
  }
}

// From 2 cells more than the vehicle on. With less it is a matter of how the walls fall on cells
// whether there is a cell that is not hard.
INSTANTIATE_TEST_SUITE_P(
    Widths,
    StraightCorridors,
    ::testing::Values(
        Widths{1.8, 1.2, 2},
        Widths{1.8, 1.2, 5.5},
        Widths{1.8, 1.2, 10},
        Widths{1, 1, 3},
        Widths{0.6, 1.4, 2.5},
        Widths{0.6, 1.4, 9},
        Widths{0.3, 1.4, 7}));

TEST(SafetyStrip, IsNotInCorridorsThatAreTooNarrow)
{
  for (int angle = 0; angle < 180; angle += 15)
  {
    Corridor corridor{kMiddle, static_cast<double>(angle)};
    corridor.width = 2 * 9 - 1.5;
    BufferScene scene(kEdge);
    scene.add([&](Place p) { return corridor.isWall(p); });
    EXPECT_EQ(lookAlong(scene, corridor, with(1.8, 1.2)).cells, 0U) << angle;
  }
}

TEST(SafetyStrip, IsNotInCorridorsWithRoomBesideTheBuffers)
{
  Corridor corridor{kMiddle, 20};
  corridor.width = 2 * 15 + 3;
  BufferScene scene(kEdge);
  scene.add([&](Place p) { return corridor.isWall(p); });
  const Seen seen = lookAlong(scene, corridor, with(1.8, 1.2));
  EXPECT_EQ(seen.cells, 0U);
  EXPECT_TRUE(seen.leads_through);
}

size_t stripCells(const Shape& shape, const BufferParams& params)
{
  BufferScene scene(kEdge);
  scene.add(shape);
  const std::vector<uint8_t> zones = scene.buffer(params);
  return static_cast<size_t>(std::count(zones.begin(), zones.end(), kStrip));
}

/** A shape about zero, turned and put into the scene's middle. */
Shape turned(int angle_deg, const Shape& shape)
{
  const Corridor frame{kMiddle, static_cast<double>(angle_deg)};
  return [frame, shape](Place p) { return shape(frame.along(p)); };
}

TEST(SafetyStrip, IsNotAtSingleObstacles)
{
  for (const auto& [name, shape] : singleObstacles())
  {
    for (int angle = 0; angle < 180; angle += 15)
    {
      for (const auto& [hard_m, soft_m] : {std::pair<double, double>{1.8, 1.2}, {1, 1}, {0.6, 1.4}})
      {
        EXPECT_EQ(stripCells(turned(angle, shape), with(hard_m, soft_m)), 0U)
            << name << " turned by " << angle << ", hard " << hard_m;
      }
    }
  }
}

TEST(SafetyStrip, IsNotAtRaggedObstacles)
{
  for (uint32_t seed = 1; seed <= 12; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<double> radii(360, 20);
    for (size_t i = 1; i < radii.size(); ++i)
    {
      radii[i] =
          std::clamp(radii[i - 1] + (static_cast<double>(random() % 201) - 100) / 100, 14., 26.);
    }
    const Shape blob = [&](Place p)
    {
      const double turn = (geometry::angleOf(p.y, p.x) + geometry::kPi) / (2 * geometry::kPi);
      const double radius = radii[std::min<size_t>(static_cast<size_t>(turn * 360), 359)];
      return p.x * p.x + p.y * p.y < radius * radius;
    };
    std::vector<double> teeth(200);
    std::generate(teeth.begin(), teeth.end(), [&] { return static_cast<double>(random() % 5); });
    const Shape wall = [&](Place p)
    { return std::abs(p.x) < 99 && p.y > -5 && p.y < teeth[static_cast<size_t>(p.x + 99)]; };
    for (const auto& [hard_m, soft_m] : {std::pair<double, double>{1.8, 1.2}, {1, 1}})
    {
      EXPECT_EQ(stripCells(turned(0, blob), with(hard_m, soft_m)), 0U) << seed << ", " << hard_m;
      EXPECT_EQ(stripCells(turned(20, wall), with(hard_m, soft_m)), 0U) << seed << ", " << hard_m;
    }
  }
}

TEST(SafetyStrip, StaysOneBetweenRaggedWallsAndInTheirMiddle)
{
  for (uint32_t seed = 1; seed <= 10; ++seed)
  {
    std::mt19937 random(seed);
    Corridor corridor{kMiddle, seed * 17.0};
    corridor.width = 25;
    corridor.length = 80;
    const auto teeth = [&]
    {
      std::vector<double> all(200);
      std::generate(all.begin(), all.end(), [&] { return static_cast<double>(random() % 5) - 2; });
      return all;
    };
    const std::vector<double> left = teeth();
    const std::vector<double> right = teeth();
    BufferScene scene(kEdge);
    scene.add(
        [&](Place world)
        {
          const Place p = corridor.along(world);
          const double tooth =
              (p.y > 0 ? left : right)[static_cast<size_t>(std::clamp(p.x + 100, 0., 199.))];
          return std::abs(p.x) < 40 && std::abs(p.y) > 12.5 + tooth && std::abs(p.y) < 20;
        });
    const Seen seen = lookAlong(scene, corridor, with(1.8, 1.2));
    EXPECT_TRUE(seen.leads_through) << seed;
    EXPECT_LE(seen.farthest_off, 2 + kOff_cells) << seed << ": the walls move it by their teeth";
  }
}

/** Walls at half the width from a line y = bend(x); from open space to open space. */
bool isBentConnected(const std::function<double(double)>& bend, double half_width)
{
  BufferScene scene(kEdge);
  const auto away = [&](Place p)
  {
    double nearest = 1e9;
    for (double x = 40; x <= 140; x += 0.5)
    {
      const double dx = p.x - x;
      const double dy = p.y - bend(x);
      nearest = std::min(nearest, dx * dx + dy * dy);
    }
    return std::sqrt(nearest);
  };
  scene.add(
      [&](Place p)
      {
        const double d = away(p);
        return p.x > 40 && p.x < 140 && d > half_width && d < half_width + 4;
      });
  const std::vector<uint8_t> zones = scene.buffer(with(1.8, 1.2));
  std::vector<bool> passable(zones.size());
  for (int32_t y = 0; y < kEdge; ++y)
  {
    for (int32_t x = 0; x < kEdge; ++x)
    {
      const uint8_t zone = zones[scene.index(x, y)];
      const bool is_inside = x <= 40 || x >= 140 || away({x + 0.5, y + 0.5}) < half_width;
      passable[scene.index(x, y)] = is_inside && (zone == kStrip || zone == kNone);
    }
  }
  return Reach(passable, kEdge, scene.index(5, 90), 8).has(scene.index(175, 90));
}

TEST(SafetyStrip, FollowsCurvesAndBends)
{
  const auto curve = [](double x) { return 90 + 20 * geometry::sinCosOf((x - 40) / 18).sin; };
  const auto bend = [](double x) { return x < 90 ? 60 + 0.6 * (x - 40) : 90 - 0.6 * (x - 90); };
  for (const double half_width : {10.5, 12., 14.})
  {
    EXPECT_TRUE(isBentConnected(curve, half_width)) << half_width;
    EXPECT_TRUE(isBentConnected(bend, half_width)) << half_width;
  }
}
}  // namespace
