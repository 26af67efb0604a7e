// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_3.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  buildings = 20,
  lines,
  trees,
  bushes,
  poles,
  stones,
  lumps,
  grass
};

/** How far the leaves go beyond the end of a branch, as a factor of its length; see addTree(). */
constexpr double kLeaves = 1.45;
}  // namespace

void Paper3::addThings()
{
  addTrees();
  addBuildings();
  addFencesAndWalls();
  addPoles();
  addBushes();
  addStones();
  addLumps();
  addGrass();
}

void Paper3::addBuildings()
{
  Random random = randomFor(Purpose::buildings);
  const int n = about(asks_.buildings, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::building);
    p.length_m = rounded(random, 5, 13);
    p.width_m = rounded(random, 4, 8);
    p.height_m = rounded(random, 2.4, 6.5);
    p.yaw_deg = rounded(random, -180, 180);
    p.material = choose(random.chance(0.5) ? Material::brick : Material::wood);
    const double radius = std::sqrt(p.length_m * p.length_m + p.width_m * p.width_m) / 2 + 0.5;
    putSomewhere(p, radius, 8, random);
  }
}

void Paper3::addLongThing(ObjectParams thing, Random& random)
{
  constexpr int kTries = 60;
  for (int i = 0; i < kTries; ++i)
  {
    const double along = random.uniform(-24, 16);
    const double share = random.uniform();
    const double off = half_road_m_ + 0.6 + kerb_m_ * random.index(2) + share * share * 12;
    const Eigen::Vector2d at = way_.place(along, random.chance(0.5) ? off : -off);
    const double aside = random.chance(0.7) ? random.uniform(-12, 12) : random.uniform(60, 120);
    const double yaw = std::remainder(way_.yawDeg(along) + aside, 360);
    const auto [s, c] = geometry::sinCosOf(yaw * (geometry::kPi / 180));
    const Eigen::Vector2d end = at + thing.length_m * Eigen::Vector2d(c, s);
    const std::vector<Disc> discs = discsAlong({at.x(), end.x()}, {at.y(), end.y()}, 0.25);
    if (plot_.areFree(discs, half_road_m_ + 0.2))
    {
      plot_.take(discs);
      thing.yaw_deg = inMillimetres(yaw);
      put(std::move(thing), at, random);
      return;
    }
  }
}

void Paper3::addFencesAndWalls()
{
  Random random = randomFor(Purpose::lines);
  const int fences = about(asks_.fences, random);
  for (int i = 0; i < fences; ++i)
  {
    ObjectParams p = object(i % 2 == 0 ? ObjectKind::fence_wire : ObjectKind::fence_board);
    p.length_m = rounded(random, 4, 14);
    p.height_m = rounded(random, 0.8, 1.7);
    if (p.kind == ObjectKind::fence_wire)
    {
      p.width_m = rounded(random, 0.003, 0.006);
    }
    addLongThing(p, random);
  }
  const int walls = about(asks_.walls, random);
  for (int i = 0; i < walls; ++i)
  {
    ObjectParams p = object(ObjectKind::wall);
    p.length_m = rounded(random, 3, 11);
    p.width_m = rounded(random, 0.15, 0.4);
    p.height_m = rounded(random, 0.4, 2.3);
    addLongThing(p, random);
  }
}

bool Paper3::addTree(ObjectParams tree, double along_m, double left_m, Random& random)
{
  const double radius = tree.radius_m + 0.15;
  const Eigen::Vector2d at = way_.place(along_m, left_m);
  const double from_way = way_.distanceTo(at);
  const bool high = tree.branch_height_m >= 2.5;
  if (!high)
  {
    // what hangs low stays off the vehicle's way
    const double most = from_way - kDriveFree_m - 0.2;
    tree.width_m = inMillimetres(std::min(tree.width_m, 2 * most / kLeaves));
    tree.branch_m = inMillimetres(std::min(tree.branch_m, most / kLeaves));
  }
  if (!plot_.isFree({at, radius}, half_road_m_ + 0.2) || tree.width_m < 0.5)
  {
    return false;
  }
  plot_.take({at, radius});
  put(std::move(tree), at, random);
  return true;
}

bool Paper3::addOverhang(bool low, Random& random)
{
  ObjectParams p = object(ObjectKind::tree);
  const double along = random.uniform(-15, 15);
  const double side = random.chance(0.5) ? 1 : -1;
  const double off = half_road_m_ + random.uniform(0.5, 1.5);
  p.radius_m = rounded(random, 0.1, 0.25);
  p.branch_height_m = low ? rounded(random, 1.1, 1.9) : rounded(random, 2.55, 3.6);
  p.height_m = inMillimetres(p.branch_height_m + random.uniform(2, 4));
  p.width_m = rounded(random, 2, 4);
  p.branch_m = inMillimetres(off * random.uniform(0.6, 1));
  p.count = 500 + static_cast<int>(random.index(1000));
  // its x axis points across the road
  p.yaw_deg = inMillimetres(std::remainder(way_.yawDeg(along) - side * 90, 360));
  return addTree(p, along, side * off, random);
}

void Paper3::addTrees()
{
  constexpr int kTries = 30;
  Random random = randomFor(Purpose::trees);
  const int n = about(asks_.trees, random);
  for (int i = 0; i < n; ++i)
  {
    if (i < 2 || random.chance(0.15))
    {
      for (int attempt = 0; attempt < kTries && !addOverhang(i % 2 == 0, random); ++attempt)
      {
      }
      continue;
    }
    ObjectParams p = object(ObjectKind::tree);
    p.radius_m = rounded(random, 0.04, 0.3);
    p.branch_height_m = rounded(random, 0.5, 3.5);
    p.height_m = inMillimetres(p.branch_height_m + random.uniform(1.5, 6));
    p.width_m = rounded(random, 1.2, 4.5);
    p.yaw_deg = rounded(random, -180, 180);
    p.count = 300 + static_cast<int>(random.index(1200));
    const double share = random.uniform();
    const double off = half_road_m_ + 0.7 + 16 * share * share;
    const double along = random.uniform(-26, 26);
    addTree(p, along, random.chance(0.5) ? off : -off, random);
  }
}

void Paper3::addBushes()
{
  Random random = randomFor(Purpose::bushes);
  const int n = about(asks_.bushes, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::bush);
    p.width_m = rounded(random, 0.6, 2.2);
    p.height_m = rounded(random, 0.4, 1.9);
    // as dense for each size
    p.count = 150 + static_cast<int>(450 * p.width_m * p.width_m * p.height_m);
    putSomewhere(p, p.width_m / 2 + 0.1, 10, random);
  }
}

void Paper3::addPoles()
{
  Random random = randomFor(Purpose::poles);
  const int n = about(asks_.poles, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::pole);
    p.radius_m = rounded(random, 0.025, 0.14);
    p.height_m = rounded(random, 0.7, 6);
    p.material = choose(random.chance(0.5) ? Material::metal : Material::wood);
    putSomewhere(p, p.radius_m, 4, random);
  }
}

void Paper3::addStones()
{
  Random random = randomFor(Purpose::stones);
  const int n = about(asks_.things, random);
  for (int i = 0; i < n; ++i)
  {
    constexpr std::array<ObjectKind, 3> kKinds = {
        ObjectKind::box, ObjectKind::cylinder, ObjectKind::hemisphere};
    ObjectParams p = object(kKinds[random.index(3)]);
    p.length_m = rounded(random, 0.3, 1.4);
    p.width_m = rounded(random, 0.3, 1.4);
    p.height_m = rounded(random, 0.3, 1.2);
    p.radius_m = rounded(random, 0.15, 0.6);
    p.yaw_deg = rounded(random, -180, 180);
    putSomewhere(p, 1, 8, random);
  }
}

void Paper3::addLumps()
{
  Random random = randomFor(Purpose::lumps);
  const int n = asks_.lump_fields == 0 ? 0 : std::max(2, about(asks_.lump_fields, random));
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::lumps);
    p.length_m = rounded(random, 3, 9);
    p.width_m = i < 2 ? rounded(random, 1.2, 4) : rounded(random, 2, 8);
    p.height_m = rounded(random, 0.07, 0.09);
    p.radius_m = rounded(random, 0.08, 0.16);
    p.count = 10 + static_cast<int>(p.length_m * p.width_m * random.uniform(3, 10));
    p.material = choose(winter_ || random.chance(0.2) ? Material::snow : Material::soil);
    // the first ones reach the vehicle's sight for sure: beside its way
    const double along = i < 2 ? random.uniform(-14, 14) : random.uniform(-24, 24);
    const double most = i < 2 ? 1.5 : 14;
    const double off = kDriveFree_m + 0.4 + p.width_m / 2 + random.uniform(0, most);
    const Eigen::Vector2d at = way_.place(along, (i % 2 == 0 ? 1 : -1) * off);
    p.yaw_deg = inMillimetres(way_.yawDeg(along));
    put(p, at, random);
  }
}

void Paper3::addGrass()
{
  Random random = randomFor(Purpose::grass);
  const int n = about(asks_.grass_patches, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p = object(ObjectKind::grass);
    p.length_m = rounded(random, 2, 7);
    p.width_m = rounded(random, 1.2, 4);
    p.height_m = rounded(random, 0.05, 0.4);
    p.count = 120 + static_cast<int>(random.index(300));
    const double along = random.uniform(-22, 22);
    const double share = random.uniform();
    const double off = half_road_m_ + 0.2 + p.width_m / 2 + share * share * 8;
    const Eigen::Vector2d at = way_.place(along, random.chance(0.5) ? off : -off);
    p.yaw_deg = inMillimetres(way_.yawDeg(along));
    put(p, at, random);
  }
}
}  // namespace traverse::simulation
