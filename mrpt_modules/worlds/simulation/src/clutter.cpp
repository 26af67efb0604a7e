// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"

#include <traverse/geometry/exact_trig.h>

// Boxes, cylinders and walls anyhow, from one corner to the opposite one.
namespace traverse::simulation
{
namespace
{
constexpr uint64_t kThings = 1;
constexpr double kCorner_m = 3.5;  // of start and goal from the ground's corner
constexpr double kGap_m = 0.4;     // nothing leans on another thing

Eigen::Vector2d anywhere(const SceneExtentParams& e, Random& random)
{
  const double x = random.uniform(e.min_x_m, e.max_x_m);
  return {x, random.uniform(e.min_y_m, e.max_y_m)};
}

/** Tries to put one there. */
bool putOne(MissionWorld& world, const Eigen::Vector2d& at, Random& random)
{
  const double kind = random.uniform();
  const double yaw = random.uniform(-180, 180);
  const double height = rounded(random, 0.5, 1.8);
  if (kind < 0.25)
  {
    const auto [s, c] = geometry::sinCosOf(yaw * (geometry::kPi / 180));
    const Eigen::Vector2d to = at + random.uniform(2, 5) * Eigen::Vector2d(c, s);
    return world.putIfFree(wallBetween(at, to, height), lineBetween(at, to, kWall_m / 2), kGap_m);
  }
  if (kind < 0.6)
  {
    ObjectParams drum = standingAt(object(ObjectKind::cylinder), at, 0);
    drum.radius_m = rounded(random, 0.2, 0.8);
    drum.height_m = height;
    return world.putIfFree(drum, discAt(at, drum.radius_m), kGap_m);
  }
  ObjectParams box = standingAt(object(ObjectKind::box), at, yaw);
  box.length_m = rounded(random, 0.4, 2);
  box.width_m = rounded(random, 0.4, 2);
  box.height_m = height;
  return world.putIfFree(box, boxStand(box), kGap_m);
}
}  // namespace

void addClutter(SceneParams& scene, uint64_t seed)
{
  constexpr int kTries = 40;
  MissionWorld world(scene, seed, {20, 20});
  const SceneExtentParams& e = world.area();
  world.addRoughness();
  world.addBorder(1.2);
  world.setMission(
      {{e.min_x_m + kCorner_m, e.min_y_m + kCorner_m},
       {e.max_x_m - kCorner_m, e.max_y_m - kCorner_m}});
  Random random = world.randomFor(kThings);
  for (int i = 0; i < world.asks().things; ++i)
  {
    for (int attempt = 0; attempt < kTries; ++attempt)
    {
      if (putOne(world, anywhere(e, random), random))
      {
        break;
      }
    }
  }
  world.proposeDrive();
}
}  // namespace traverse::simulation
