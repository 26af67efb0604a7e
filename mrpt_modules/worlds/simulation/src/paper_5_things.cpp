// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_5.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  traffic = 20,
  parked,
  buildings,
  walls,
  small,
  people
};

constexpr int kTries = 40;
constexpr double kPerson_m = 0.6;  // with what an outline may touch beside it
constexpr double kLane_m = 2.9;    // of traffic beside the way's middle

ObjectParams vehicle(Random& random)
{
  ObjectParams p = object(ObjectKind::vehicle);
  p.length_m = inMillimetres(random.uniform(3.6, 5));
  p.width_m = inMillimetres(random.uniform(1.6, 1.95));
  p.height_m = inMillimetres(random.uniform(1.35, 2));
  return p;
}
}  // namespace

void Paper5::addTraffic()
{
  Random random = randomFor(Purpose::traffic);
  const int oncoming = about(asks_.moving_vehicles, random);
  const int ahead = about(asks_.moving_vehicles, random);
  for (const double side : {1.0, -1.0})
  {
    const auto [xs, ys] = way_.beside(-half_m_ - 20, half_m_ + 20, side * kLane_m);
    plot_.take(discsAlong(xs, ys, 1.2));
  }
  // one draw a statement: the order within one is the compiler's choice
  const double against_mps = rounded(random, 5, 14);
  const double against_m = random.uniform(40, 90);
  const double against_gap_m = random.uniform(25, 60);
  addColumn(1, against_m, against_gap_m, 200, against_mps, oncoming);
  const double along_mps = rounded(random, 3, 9);
  const double along_m = random.uniform(12, 40);
  addColumn(-1, along_m, random.uniform(20, 45), 120, along_mps, ahead);
}

void Paper5::addColumn(
    double side, double from_m, double gap_m, double way_m, double speed_mps, int n)
{
  constexpr double kStanding_m = 8;  // from one car to the next where they stop
  Random random = randomFor(Purpose::traffic + (side > 0 ? 100 : 200));
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = vehicle(random);
    const double begin = -half_m_ + from_m + gap_m * i;
    const double first =
        side > 0 ? std::max(begin - way_m, -half_m_ - 25 + kStanding_m * i) : begin;
    const double last =
        side > 0 ? begin : std::min(begin + way_m, half_m_ + 25 - kStanding_m * (n - 1 - i));
    if (last < first + 4 || last > half_m_ + 25)
    {
      continue;
    }
    std::tie(p.track_xs_m, p.track_ys_m) = way_.beside(first, last, side * kLane_m);
    if (side > 0)
    {
      std::reverse(p.track_xs_m.begin(), p.track_xs_m.end());
      std::reverse(p.track_ys_m.begin(), p.track_ys_m.end());
    }
    p.speed_mps = speed_mps;
    scene_.objects.push_back(p);
  }
}

void Paper5::addParkedVehicles()
{
  Random random = randomFor(Purpose::parked);
  const int n = about(asks_.parked_vehicles, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = vehicle(random);
    for (int attempt = 0; attempt < kTries; ++attempt)
    {
      const double along = anywhere(random);
      const double on = side(random);
      const double off = on * (half_road_m_ + 1.2 + random.uniform(0, 1.2));
      const Eigen::Vector2d at = way_.place(along, off);
      const Eigen::Vector2d rear = way_.place(along - p.length_m / 2, off);
      const Eigen::Vector2d front = way_.place(along + p.length_m / 2, off);
      const std::vector<Disc> discs =
          discsAlong({rear.x(), front.x()}, {rear.y(), front.y()}, p.width_m / 2 + 0.3);
      if (plot_.areFree(discs, half_road_m_ - 0.6))
      {
        plot_.take(discs);
        p.yaw_deg = inMillimetres(
            std::remainder(way_.yawDeg(along) + random.uniform(-4, 4) + (off > 0 ? 180 : 0), 360));
        put(p, at);
        break;
      }
    }
  }
}

void Paper5::put(ObjectParams thing, const Eigen::Vector2d& at)
{
  thing.x_m = inMillimetres(at.x());
  thing.y_m = inMillimetres(at.y());
  scene_.objects.push_back(std::move(thing));
}

void Paper5::putSomewhere(ObjectParams thing, double radius_m, double farthest_m, Random& random)
{
  for (int i = 0; i < kTries; ++i)
  {
    const double along = anywhere(random);
    const double share = random.uniform();
    const double off = half_road_m_ + 0.3 + radius_m + share * share * farthest_m;
    const Eigen::Vector2d at = way_.place(along, side(random) * off);
    if (plot_.isFree({at, radius_m}, half_road_m_))
    {
      plot_.take({at, radius_m});
      thing.seed = seedOf(random);
      put(std::move(thing), at);
      return;
    }
  }
}

void Paper5::addBuildings()
{
  Random random = randomFor(Purpose::buildings);
  const int n = about(asks_.buildings, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::building);
    p.length_m = rounded(random, 6, 16);
    p.width_m = rounded(random, 5, 9);
    p.height_m = rounded(random, 3, 8);
    p.yaw_deg = rounded(random, -60, 60);
    const double radius = std::sqrt(p.length_m * p.length_m + p.width_m * p.width_m) / 2 + 0.5;
    putSomewhere(p, radius, 10, random);
  }
}

void Paper5::addWalls()
{
  Random random = randomFor(Purpose::walls);
  const int n = about(asks_.walls + asks_.fences, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(random.chance(0.6) ? ObjectKind::wall : ObjectKind::fence_board);
    p.length_m = rounded(random, 4, 18);
    p.height_m = rounded(random, 0.6, 2.5);
    p.seed = seedOf(random);
    for (int attempt = 0; attempt < kTries; ++attempt)
    {
      const double along = anywhere(random);
      const double share = random.uniform();
      const double off = half_road_m_ + 1 + share * share * 14;
      const Eigen::Vector2d at = way_.place(along, side(random) * off);
      const double aside = random.chance(0.7) ? random.uniform(-8, 8) : random.uniform(50, 130);
      const double yaw = std::remainder(way_.yawDeg(along) + aside, 360);
      const auto [s, c] = geometry::sinCosOf(yaw * (geometry::kPi / 180));
      const Eigen::Vector2d end = at + p.length_m * Eigen::Vector2d(c, s);
      const std::vector<Disc> discs = discsAlong({at.x(), end.x()}, {at.y(), end.y()}, 0.45);
      if (plot_.areFree(discs, half_road_m_ + 0.2))
      {
        plot_.take(discs);
        p.yaw_deg = inMillimetres(yaw);
        put(p, at);
        break;
      }
    }
  }
}

void Paper5::addSmallThings()
{
  Random random = randomFor(Purpose::small);
  const int trees = about(asks_.trees, random);
  for (int i = 0; i < trees; ++i)
  {
    ObjectParams p = object(ObjectKind::tree);
    p.radius_m = rounded(random, 0.08, 0.3);
    p.branch_height_m = rounded(random, 2.6, 3.6);
    p.height_m = inMillimetres(p.branch_height_m + random.uniform(2, 4));
    p.width_m = rounded(random, 2, 4);
    p.yaw_deg = rounded(random, -180, 180);
    p.branch_m = rounded(random, 1, 4);
    p.count = 400;
    putSomewhere(p, p.radius_m + 0.3, 6, random);
  }
  const int poles = about(asks_.poles, random);
  for (int i = 0; i < poles; ++i)
  {
    ObjectParams p = object(ObjectKind::pole);
    p.radius_m = rounded(random, 0.04, 0.15);
    p.height_m = rounded(random, 0.8, 6);
    putSomewhere(p, p.radius_m + 0.3, 4, random);
  }
  const int things = about(asks_.things, random);
  for (int i = 0; i < things; ++i)
  {
    constexpr std::array<ObjectKind, 4> kKinds = {
        ObjectKind::box, ObjectKind::cylinder, ObjectKind::table, ObjectKind::gate};
    ObjectParams p = object(kKinds[random.index(4)]);
    p.length_m = rounded(random, 0.4, 1.4);
    p.width_m = rounded(random, 0.4, 1.4);
    p.height_m = rounded(random, 0.4, 1.4);
    p.radius_m = p.kind == ObjectKind::gate ? 0.06 : rounded(random, 0.2, 0.6);
    p.yaw_deg = rounded(random, -180, 180);
    putSomewhere(p, 1.3, 8, random);
  }
}

void Paper5::addPeople()
{
  Random random = randomFor(Purpose::people);
  const int n = about(asks_.people, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::person);
    p.height_m = rounded(random, 1.2, 1.95);
    p.speed_mps = rounded(random, 0.6, 2);
    p.start_s = rounded(random, 0, 3);
    for (int attempt = 0; attempt < kTries; ++attempt)
    {
      const double on = side(random);
      const double from = anywhere(random);
      const double to = from + random.uniform(-20, 20);
      const double share = random.uniform();
      const double off = half_road_m_ + kPerson_m + 0.2 + share * share * 8;
      const double end = std::max(half_road_m_ + kPerson_m + 0.2, off + random.uniform(-5, 5));
      const Eigen::Vector2d a = way_.place(from, on * off);
      const Eigen::Vector2d b = way_.place(to, on * end);
      p.track_xs_m = {inMillimetres(a.x()), inMillimetres(b.x())};
      p.track_ys_m = {inMillimetres(a.y()), inMillimetres(b.y())};
      const std::vector<Disc> discs = (b - a).norm() > 3
                                          ? discsAlong(p.track_xs_m, p.track_ys_m, kPerson_m)
                                          : std::vector<Disc>();
      if (!discs.empty() && plot_.areFree(discs, half_road_m_))
      {
        plot_.take(discs);
        scene_.objects.push_back(p);
        break;
      }
    }
  }
}
}  // namespace traverse::simulation
