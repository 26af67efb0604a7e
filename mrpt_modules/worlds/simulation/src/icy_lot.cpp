// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"

#include <array>

// A flat parking lot: two lanes between four rows of cars, patches of ice on the lanes.
namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  cars = 1,
  ice,
  places
};

constexpr double kLane_m = 8.75;     // of a lane's middle from the middle of the lot
constexpr double kHalfLane_m = 3.5;  // of what stays free
constexpr double kRows_m = 24;       // of the rows' ends from the middle
constexpr double kStall_m = 2.7;

void addCars(MissionWorld& world)
{
  constexpr std::array<double, 4> kRowYs = {-15, -2.55, 2.55, 15};
  constexpr int kTries = 6;
  constexpr int kStalls = static_cast<int>(2 * kRows_m / kStall_m);
  Random random = world.randomFor(Purpose::cars);
  int left = about(world.asks().parked_vehicles, random);
  for (int i = 0; i < kTries * world.asks().parked_vehicles && left > 0; ++i)
  {
    const double y = kRowYs[random.index(4)];
    const double stall = random.index(kStalls) + 0.5;
    const double x = -kRows_m + stall * kStall_m + random.uniform(-0.15, 0.15);
    const Eigen::Vector2d at(x, y + random.uniform(-0.1, 0.1));
    const double looks = random.chance(0.5) ? 90 : -90;
    ObjectParams car = standingAt(object(ObjectKind::vehicle), at, looks + random.uniform(-3, 3));
    car.length_m = rounded(random, 3.7, 4.9);
    car.width_m = rounded(random, 1.6, 1.9);
    car.height_m = rounded(random, 1.35, 1.9);
    left -= world.putIfFree(car, boxStand(car), 0.2) ? 1 : 0;
  }
}

/** Flat strips of ice; where the vehicle drives. */
void addIce(MissionWorld& world)
{
  Random random = world.randomFor(Purpose::ice);
  const int n = about(world.asks().ice_patches, random);
  for (int i = 0; i < n; ++i)
  {
    const double lane = random.chance(0.5) ? kLane_m : -kLane_m;
    TerrainParams ice;
    ice.kind = TerrainKind::road;
    ice.x_m = rounded(random, -kRows_m, kRows_m);
    ice.y_m = inMillimetres(lane + random.uniform(-3, 3));
    ice.yaw_deg = rounded(random, -180, 180);
    ice.length_m = rounded(random, 3, 8);
    ice.width_m = rounded(random, 2, 5);
    ice.material = choose(Material::ice);
    world.addTerrain(ice);
  }
}
}  // namespace

void addIcyLot(SceneParams& scene, uint64_t seed)
{
  constexpr double kStart_m = 20;
  constexpr double kEast_m = 27;
  MissionWorld world(scene, seed, {58, 36});
  world.addRoughness();
  addIce(world);
  world.addBorder(0.8);
  Random random = world.randomFor(Purpose::places);
  const double aside = random.chance(0.5) ? 1 : -1;
  const double lane = aside * kLane_m;
  world.setMission(
      {{-kStart_m, lane},
       {kEast_m, lane + random.uniform(-1, 1)},
       {random.uniform(0, kStart_m), -lane + random.uniform(-1, 1)}});
  for (const double y : {kLane_m, -kLane_m})
  {
    world.keepClear(lineBetween({-kEast_m, y}, {kEast_m, y}, kHalfLane_m));
  }
  addCars(world);
  world.proposeDrive();
}
}  // namespace traverse::simulation
