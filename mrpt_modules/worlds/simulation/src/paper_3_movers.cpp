// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_3.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  moving = 40,
  parked,
  people
};

constexpr double kPerson_m = 0.35;
constexpr double kReach_m = 24;
constexpr double kApart_m = 7;

ObjectParams vehicle(Random& random)
{
  ObjectParams p;
  p.kind = ObjectKind::vehicle;
  p.length_m = inMillimetres(random.uniform(3.6, 5));
  p.width_m = inMillimetres(random.uniform(1.6, 1.95));
  p.height_m = inMillimetres(random.uniform(1.35, 2));
  return p;
}
}  // namespace

void Paper3::addMovingVehicles()
{
  Random random = randomFor(Purpose::moving);
  const int n = about(asks_.moving_vehicles, random);
  const double side = lane_side_;
  const double speed_mps = rounded(random, 2, 9);
  const double start_s = rounded(random, 0, 5);
  if (n > 0)
  {
    const auto [xs, ys] = way_.beside(-kReach_m, kReach_m, side * lane_m_);
    plot_.take(discsAlong(xs, ys, 1));
  }
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = vehicle(random);
    // a column of cars, each behind the one before, at their beginnings and ends too
    const double first = kReach_m - kApart_m * i;
    const double last = -kReach_m + kApart_m * (n - 1 - i);
    std::tie(p.track_xs_m, p.track_ys_m) = way_.beside(last, first, side * lane_m_);
    if (side > 0)
    {
      // on the left against the vehicle's direction: the last of the column comes first
      std::reverse(p.track_xs_m.begin(), p.track_xs_m.end());
      std::reverse(p.track_ys_m.begin(), p.track_ys_m.end());
    }
    p.speed_mps = speed_mps;
    p.start_s = start_s;
    scene_.objects.push_back(p);
  }
}

void Paper3::addParkedVehicles()
{
  Random random = randomFor(Purpose::parked);
  const int n = about(asks_.parked_vehicles, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = vehicle(random);
    for (int attempt = 0; attempt < 40; ++attempt)
    {
      const double along = random.uniform(-20, 20);
      const double off =
          std::max(kDriveFree_m + p.width_m / 2 + 0.35, half_road_m_ + random.uniform(-0.8, 2.5));
      const double side = random.chance(0.5) ? 1 : -1;
      const Eigen::Vector2d at = way_.place(along, side * off);
      const double yaw = way_.yawDeg(along) + (random.chance(0.5) ? 0 : 180);
      const Eigen::Vector2d rear = way_.place(along - p.length_m / 2, side * off);
      const Eigen::Vector2d front = way_.place(along + p.length_m / 2, side * off);
      const std::vector<Disc> discs =
          discsAlong({rear.x(), front.x()}, {rear.y(), front.y()}, p.width_m / 2 + 0.2);
      if (plot_.areFree(discs, kDriveFree_m))
      {
        plot_.take(discs);
        p.x_m = inMillimetres(at.x());
        p.y_m = inMillimetres(at.y());
        p.yaw_deg = inMillimetres(std::remainder(yaw + random.uniform(-4, 4), 360));
        scene_.objects.push_back(p);
        break;
      }
    }
  }
}

void Paper3::addPeople()
{
  Random random = randomFor(Purpose::people);
  const int n = about(asks_.people, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p;
    p.kind = ObjectKind::person;
    p.height_m = rounded(random, 1.2, 1.95);
    if (random.chance(0.25))
    {
      p.yaw_deg = rounded(random, -180, 180);
      putSomewhere(p, kPerson_m, 6, random);
      continue;
    }
    for (int attempt = 0; attempt < 60; ++attempt)
    {
      const double side = random.chance(0.5) ? 1 : -1;
      const double from = random.uniform(-22, 22);
      const double to = std::clamp(from + random.uniform(-18, 18), -24.0, 24.0);
      const double share = random.uniform();
      const double off = kDriveFree_m + 0.6 + share * share * 9;
      const double end = std::max(kDriveFree_m + 0.6, off + random.uniform(-5, 5));
      const double half_way = random.uniform(0.3, 0.7);
      const Eigen::Vector2d a = way_.place(from, side * off);
      const Eigen::Vector2d b =
          way_.place(from + (to - from) * half_way, side * (off + random.uniform(0, 2)));
      const Eigen::Vector2d c = way_.place(to, side * end);
      p.track_xs_m = {inMillimetres(a.x()), inMillimetres(b.x()), inMillimetres(c.x())};
      p.track_ys_m = {inMillimetres(a.y()), inMillimetres(b.y()), inMillimetres(c.y())};
      p.speed_mps = rounded(random, 0.5, 1.7);
      p.start_s = rounded(random, 0, 4);
      const bool walks = (b - a).norm() > 0.5 && (c - b).norm() > 0.5;
      if (walks && plot_.areFree(discsAlong(p.track_xs_m, p.track_ys_m, kPerson_m), kDriveFree_m))
      {
        scene_.objects.push_back(p);
        break;
      }
    }
  }
}
}  // namespace traverse::simulation
