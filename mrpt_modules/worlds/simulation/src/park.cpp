// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/build.h>

#include <algorithm>
#include <cmath>

// A path that winds over hills; ditches across it that leave it a crossing; trees, bushes, benches.
namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  hills = 1,
  path,
  ditches,
  woods
};

constexpr double kPath_m = 2.4;  // wide

using Line = std::vector<Eigen::Vector2d>;

/** The steepest slope of a ground, on a lattice of 0.5 m. */
double steepest(const Terrain& terrain, const SceneExtentParams& e)
{
  constexpr double kApart_m = 0.5;
  const auto columns = static_cast<int>((e.max_x_m - e.min_x_m) / kApart_m);
  const auto rows = static_cast<int>((e.max_y_m - e.min_y_m) / kApart_m);
  double most = 0;
  for (int i = 0; i < columns * rows; ++i)
  {
    const int row = i / columns;
    const double x = e.min_x_m + i % columns * kApart_m;
    const double y = e.min_y_m + row * kApart_m;
    const double here = terrain.at(x, y).base_m;
    const double east = (terrain.at(x + kApart_m, y).base_m - here) / kApart_m;
    const double north = (terrain.at(x, y + kApart_m).base_m - here) / kApart_m;
    most = std::max(most, east * east + north * north);
  }
  return std::sqrt(most);
}

/** Hills as high as makes them as steep as is asked for. */
void addHills(MissionWorld& world)
{
  Random random = world.randomFor(Purpose::hills);
  TerrainParams p;
  p.kind = TerrainKind::hills;
  p.wavelength_m = rounded(random, 18, 28);
  p.seed = seedOf(random);
  p.height_m = 1;
  SceneParams alone;
  alone.extent = world.area();
  alone.terrains = {p};
  const double wanted_deg = world.asks().slope_deg * random.uniform(0.7, 1);
  const double wanted = geometry::tangentOf(wanted_deg * (geometry::kPi / 180));
  p.height_m = inMillimetres(wanted / steepest(*buildTerrain(alone), world.area()));
  if (p.height_m > 0)
  {
    world.addTerrain(p);
  }
}

/** From corner to corner, in waves. */
Line windingPath(const SceneExtentParams& e, Random random)
{
  constexpr double kCorner_m = 6;
  constexpr int kSteps = 40;
  const Eigen::Vector2d from(e.min_x_m + kCorner_m, e.min_y_m + kCorner_m);
  const Eigen::Vector2d to(e.max_x_m - kCorner_m, e.max_y_m - kCorner_m);
  const Eigen::Vector2d way = to - from;
  const Eigen::Vector2d left = Eigen::Vector2d(-way.y(), way.x()) / std::sqrt(way.dot(way));
  const double side = random.chance(0.5) ? 1 : -1;
  const double wide_m = side * random.uniform(5, 9);
  const double waves = random.uniform(1, 1.6);
  const double phase = random.uniform(0, 2 * geometry::kPi);
  Line line;
  for (int i = 0; i <= kSteps; ++i)
  {
    const double share = static_cast<double>(i) / kSteps;
    const double wave = geometry::sinCosOf(2 * geometry::kPi * waves * share + phase).sin;
    line.push_back(from + share * way + 4 * share * (1 - share) * wide_m * wave * left);
  }
  return line;
}

void addPath(MissionWorld& world, const Line& line)
{
  TerrainParams p;
  p.kind = TerrainKind::road;
  p.width_m = kPath_m;
  p.material = choose(Material::soil);
  for (const Eigen::Vector2d& at : line)
  {
    p.xs_m.push_back(inMillimetres(at.x()));
    p.ys_m.push_back(inMillimetres(at.y()));
  }
  world.addTerrain(p);
  for (size_t i = 0; i + 1 < line.size(); ++i)
  {
    world.keepClear(lineBetween(line[i], line[i + 1], kPath_m / 2 + 0.3));
  }
}

bool isNear(const Stand& ditch, const Line& line)
{
  constexpr double kCrossing_m = 1.7;  // from the path's middle to a ditch
  return std::any_of(
      line.begin(), line.end(),
      [&](const Eigen::Vector2d& p) { return ditch.distanceTo(p) < kCrossing_m; });
}

/** One on each side of the path, in one line. */
void addDitches(MissionWorld& world, const Line& line)
{
  constexpr double kFrom_m = 1.9;  // half of the crossing
  Random random = world.randomFor(Purpose::ditches);
  const int n = about(world.asks().ditches, random);
  for (int i = 0; i < n; ++i)
  {
    const double share = 0.15 + 0.7 * (i + random.uniform(0.2, 0.8)) / n;
    const auto at = static_cast<size_t>(share * static_cast<double>(line.size() - 1));
    const Eigen::Vector2d way = line[at + 1] - line[at];
    const Eigen::Vector2d across = Eigen::Vector2d(-way.y(), way.x()) / std::sqrt(way.dot(way));
    TerrainParams ditch;
    ditch.kind = TerrainKind::ditch;
    ditch.width_m = rounded(random, 0.7, 1.4);
    ditch.height_m = rounded(random, 0.4, 0.8);
    ditch.edge_m = rounded(random, 0.05, 0.2);
    for (const double side : {1.0, -1.0})
    {
      const Eigen::Vector2d from = line[at] + side * kFrom_m * across;
      const Eigen::Vector2d to = from + side * random.uniform(4, 10) * across;
      ditch.xs_m = {inMillimetres(from.x()), inMillimetres(to.x())};
      ditch.ys_m = {inMillimetres(from.y()), inMillimetres(to.y())};
      const Stand stand = lineBetween(from, to, ditch.width_m / 2);
      if (!isNear(stand, line) && world.block({stand}))
      {
        world.addTerrain(ditch);
      }
    }
  }
}

ObjectParams tree(Random& random)
{
  ObjectParams p = object(ObjectKind::tree);
  p.radius_m = rounded(random, 0.08, 0.25);
  p.branch_height_m = rounded(random, 2.4, 3.2);
  p.height_m = inMillimetres(p.branch_height_m + random.uniform(2, 4));
  p.width_m = rounded(random, 2, 4);
  p.count = 400;
  return p;
}

ObjectParams bush(Random& random)
{
  ObjectParams p = object(ObjectKind::bush);
  p.width_m = rounded(random, 0.8, 1.8);
  p.height_m = rounded(random, 0.6, 1.5);
  p.count = 400;
  return p;
}

ObjectParams bench(Random& /*random*/)
{
  ObjectParams p = object(ObjectKind::table);
  p.length_m = 1.6;
  p.width_m = 0.5;
  p.height_m = 0.45;
  return p;
}

ObjectParams grass(Random& random)
{
  ObjectParams p = object(ObjectKind::grass);
  p.length_m = rounded(random, 2, 4);
  p.width_m = rounded(random, 2, 4);
  p.height_m = rounded(random, 0.15, 0.4);
  p.count = 200;
  return p;
}

/** Somewhere at least so far from the ground's ends. */
ObjectParams anywhere(MissionWorld& world, ObjectParams thing, double border_m, Random& random)
{
  const SceneExtentParams& e = world.area();
  const double x = random.uniform(e.min_x_m + border_m, e.max_x_m - border_m);
  const double y = random.uniform(e.min_y_m + border_m, e.max_y_m - border_m);
  thing.seed = seedOf(random);
  return standingAt(std::move(thing), {x, y}, random.uniform(-180, 180));
}

/** So many of what `make` makes, beside each other. */
template <class Make>
void scatter(MissionWorld& world, int mean, double radius_m, const Make& make, Random& random)
{
  constexpr int kTries = 20;
  constexpr double kGap_m = 0.4;
  const int n = about(mean, random);
  for (int i = 0; i < n; ++i)
  {
    bool done = false;
    for (int attempt = 0; attempt < kTries && !done; ++attempt)
    {
      const ObjectParams thing = anywhere(world, make(random), radius_m, random);
      const Eigen::Vector2d at(thing.x_m, thing.y_m);
      done = world.putIfFree(thing, discAt(at, radius_m), kGap_m);
    }
  }
}

void addWoods(MissionWorld& world)
{
  Random random = world.randomFor(Purpose::woods);
  scatter(world, world.asks().trees, 0.25, tree, random);
  scatter(world, world.asks().bushes, 0.9, bush, random);
  scatter(world, world.asks().things, 0.85, bench, random);
  const int patches = about(world.asks().grass_patches, random);
  for (int i = 0; i < patches; ++i)
  {
    const ObjectParams patch = grass(random);
    world.scene().objects.push_back(anywhere(world, patch, patch.length_m + 1, random));
  }
}
}  // namespace

void addPark(SceneParams& scene, uint64_t seed)
{
  MissionWorld world(scene, seed, {40, 40});
  const Line line = windingPath(world.area(), world.randomFor(Purpose::path));
  addHills(world);
  world.addRoughness();
  addPath(world, line);
  world.addBorder(1);
  world.setMission({line.front(), line.back()});
  const Eigen::Vector2d first = line[1] - line[0];
  world.lookTo(geometry::angleOf(first.y(), first.x()) * (180 / geometry::kPi));
  addDitches(world, line);
  addWoods(world);
  world.proposeDrive();
}
}  // namespace traverse::simulation
