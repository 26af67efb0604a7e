// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"

#include <algorithm>
#include <cmath>
#include <numeric>

// Rows of racks in a hall, two blocks each, with aisles of 3 m between them; people go to and fro
// along one side of an aisle, and leave the other one to vehicles.
namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  racks = 1,
  walkers,
  places,
  pallets
};

constexpr double kAisle_m = 3;
constexpr double kCross_m = 4;    // aisles across, at both ends and in the middle
constexpr double kLane_m = 1.03;  // where people walk, from an aisle's middle
constexpr double kPerson_m = 0.4;

/** Where the racks are: both blocks of a row lie between inner and outer x. */
struct Hall
{
  double inner_m = 0;
  double outer_m = 0;
  double depth_m = 0;    //!< of a rack
  double first_y_m = 0;  //!< middle of the first row
  int rows = 0;

  double rowY(int row) const { return first_y_m + row * (depth_m + kAisle_m); }

  /** Of the aisle behind a row. */
  double aisleY(int row) const { return rowY(row) + (depth_m + kAisle_m) / 2; }

  double crossX() const { return outer_m + kCross_m / 2; }
};

Hall hallIn(const SceneExtentParams& e, Random random)
{
  constexpr double kInset_m = 0.65;  // the border wall's inner side
  Hall hall;
  hall.depth_m = rounded(random, 1, 1.6);
  hall.inner_m = kCross_m / 2;
  hall.outer_m = (e.max_x_m - e.min_x_m) / 2 - kInset_m - kCross_m;
  const double high = e.max_y_m - e.min_y_m - 2 * kInset_m;
  hall.rows = static_cast<int>((high - kAisle_m) / (hall.depth_m + kAisle_m));
  const double used = (hall.rows - 1) * (hall.depth_m + kAisle_m);
  hall.first_y_m = inMillimetres((e.min_y_m + e.max_y_m) / 2 - used / 2);
  return hall;
}

void addRacks(MissionWorld& world, const Hall& hall)
{
  constexpr double kGone = 0.1;  // of the racks
  Random random = world.randomFor(Purpose::racks);
  const double middle_x = (world.area().min_x_m + world.area().max_x_m) / 2;
  for (int row = 0; row < hall.rows; ++row)
  {
    for (const double side : {-1.0, 1.0})
    {
      const double x = middle_x + side * (hall.inner_m + hall.outer_m) / 2;
      ObjectParams rack = standingAt(object(ObjectKind::box), {x, hall.rowY(row)}, 0);
      rack.length_m = inMillimetres(hall.outer_m - hall.inner_m);
      rack.width_m = hall.depth_m;
      rack.height_m = rounded(random, 2, 4);
      rack.material = choose(Material::metal);
      if (!random.chance(kGone))
      {
        world.put(rack, {boxStand(rack)});
      }
    }
  }
}

/** To and fro between two places for ten minutes, from somewhere between them. */
void walk(ObjectParams& person, const Eigen::Vector2d& a, const Eigen::Vector2d& b, Random& random)
{
  constexpr double kLong_s = 600;
  const double length = std::abs(b.x() - a.x());
  const int legs = 1 + static_cast<int>(kLong_s * person.speed_mps / length);
  const Eigen::Vector2d first = a + (b - a) * random.uniform(0.1, 0.9);
  const auto add = [&](const Eigen::Vector2d& p)
  {
    person.track_xs_m.push_back(inMillimetres(p.x()));
    person.track_ys_m.push_back(inMillimetres(p.y()));
  };
  add(first);
  const bool swaps = random.chance(0.5);
  for (int leg = 0; leg <= legs; ++leg)
  {
    add((leg % 2 == 0) == swaps ? a : b);
  }
}

/** At most one in each aisle of each block, along one side of it and never to its very ends. */
void addPeople(MissionWorld& world, const Hall& hall)
{
  constexpr double kEnd_m = 1.5;
  Random random = world.randomFor(Purpose::walkers);
  const double middle_x = (world.area().min_x_m + world.area().max_x_m) / 2;
  std::vector<int> slots(static_cast<size_t>(std::max(0, hall.rows - 1)) * 2);
  std::iota(slots.begin(), slots.end(), 0);
  for (int left = about(world.asks().people, random); left > 0 && !slots.empty(); --left)
  {
    const auto chosen = slots.begin() + random.index(static_cast<uint32_t>(slots.size()));
    const int slot = *chosen;
    slots.erase(chosen);
    const double block = slot % 2 == 0 ? -1 : 1;
    const double y = hall.aisleY(slot / 2) + (random.chance(0.5) ? kLane_m : -kLane_m);
    const Eigen::Vector2d a(middle_x + block * (hall.inner_m + kEnd_m), y);
    const Eigen::Vector2d b(middle_x + block * (hall.outer_m - kEnd_m), y);
    ObjectParams person = object(ObjectKind::person);
    person.height_m = rounded(random, 1.5, 1.95);
    person.speed_mps = rounded(random, 0.5, 1.2);
    walk(person, a, b, random);
    world.keepClear(lineBetween(a, b, kPerson_m));
    world.scene().objects.push_back(person);
  }
}

/** Beside the walls. */
void addPallets(MissionWorld& world)
{
  constexpr double kFromEnd_m = 1.1;
  Random random = world.randomFor(Purpose::pallets);
  const SceneExtentParams& e = world.area();
  const int n = about(world.asks().things, random);
  for (int i = 0; i < n; ++i)
  {
    const double x = random.uniform(e.min_x_m + 2, e.max_x_m - 2);
    const double y = random.chance(0.5) ? e.max_y_m - kFromEnd_m : e.min_y_m + kFromEnd_m;
    ObjectParams pallet = standingAt(object(ObjectKind::box), {x, y}, random.uniform(-3, 3));
    pallet.length_m = 1.2;
    pallet.width_m = 0.8;
    pallet.height_m = rounded(random, 0.3, 1.6);
    world.putIfFree(pallet, boxStand(pallet), 0);
  }
}
}  // namespace

void addWarehouse(SceneParams& scene, uint64_t seed)
{
  MissionWorld world(scene, seed, {30, 20});  // three rows of racks and more
  const Hall hall = hallIn(world.area(), world.randomFor(0));
  const double middle_x = (world.area().min_x_m + world.area().max_x_m) / 2;
  world.addBorder(3);
  addRacks(world, hall);
  Random random = world.randomFor(Purpose::places);
  const auto aisles = static_cast<uint32_t>(std::max(2, hall.rows - 1));
  const double side = random.chance(0.5) ? 1 : -1;
  const uint32_t first = random.index(aisles);
  const uint32_t second = (first + 1 + random.index(aisles - 1)) % aisles;
  const uint32_t third = (second + 1 + random.index(aisles - 1)) % aisles;
  const uint32_t last = (first + 1 + random.index(aisles - 1)) % aisles;
  const auto place = [&](double share, uint32_t aisle)
  {
    return Eigen::Vector2d(
        middle_x + share * side * hall.crossX(), hall.aisleY(static_cast<int>(aisle)));
  };
  world.setMission({place(-1, first), place(1, second), place(0, third), place(-1, last)});
  addPeople(world, hall);
  addPallets(world);
  world.proposeDrive();
}
}  // namespace traverse::simulation
