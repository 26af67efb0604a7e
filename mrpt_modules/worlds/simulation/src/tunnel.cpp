// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>

// A bent corridor between two open grounds, the only way from one to the other.
namespace traverse::simulation
{
namespace
{
enum Purpose : uint64_t
{
  line = 1,
  width,
  places,
  things
};

constexpr double kStep_m = 0.5;
constexpr double kHigh_m = 2.5;
constexpr double kEnd_m = 12;  // of open ground

/** A place of the middle line, and where it leads. */
struct Station
{
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double heading_rad = 0;

  Eigen::Vector2d beside(double left_m) const
  {
    const auto [s, c] = geometry::sinCosOf(heading_rad);
    return at + left_m * Eigen::Vector2d(-s, c);
  }

  Eigen::Vector2d ahead(double way_m) const
  {
    const auto [s, c] = geometry::sinCosOf(heading_rad);
    return at + way_m * Eigen::Vector2d(c, s);
  }
};

/** Straight, a bend, straight, a bend back, straight; its ends lie on the x axis on either side of
 * zero. */
std::vector<Station> middleLine(double length_m, Random random)
{
  const double side = random.chance(0.5) ? 1 : -1;
  const double first_rad = side * random.uniform(0.5, 0.9);
  const double second_rad = -first_rad * random.uniform(0.9, 1.5);
  const double first_m = random.uniform(5, 8) * std::abs(first_rad);
  const double second_m = random.uniform(5, 8) * std::abs(second_rad);
  const double straight_m = length_m - first_m - second_m;
  const double first_from = straight_m * random.uniform(0.25, 0.4);
  const double second_from = first_from + first_m + straight_m * random.uniform(0.2, 0.35);
  const auto share = [](double along, double from, double length)
  { return std::clamp((along - from) / length, 0.0, 1.0); };
  std::vector<Station> stations(1);
  for (int i = 0; i < static_cast<int>(length_m / kStep_m); ++i)
  {
    const double along = (i + 0.5) * kStep_m;
    Station next = stations.back();
    next.heading_rad = first_rad * share(along, first_from, first_m) +
                       second_rad * share(along, second_from, second_m);
    next.at = next.ahead(kStep_m);
    stations.push_back(next);
  }
  const Eigen::Vector2d end = stations.back().at;
  const double turn = geometry::angleOf(end.y(), end.x());
  const auto [s, c] = geometry::sinCosOf(-turn);
  const double half = std::sqrt(end.dot(end)) / 2;
  for (Station& p : stations)
  {
    p.at = Eigen::Vector2d(c * p.at.x() - s * p.at.y() - half, s * p.at.x() + c * p.at.y());
    p.heading_rad -= turn;
  }
  return stations;
}

void addWall(MissionWorld& world, const std::vector<Eigen::Vector2d>& corners)
{
  ObjectParams wall = object(ObjectKind::wall);
  wall.x_m = inMillimetres(corners.front().x());
  wall.y_m = inMillimetres(corners.front().y());
  wall.width_m = kWall_m;
  wall.height_m = kHigh_m;
  for (const Eigen::Vector2d& corner : corners)
  {
    wall.xs_m.push_back(inMillimetres(corner.x() - wall.x_m));
    wall.ys_m.push_back(inMillimetres(corner.y() - wall.y_m));
  }
  std::vector<Stand> stands;
  for (size_t i = 0; i + 1 < corners.size(); ++i)
  {
    stands.push_back(lineBetween(corners[i], corners[i + 1], kWall_m / 2));
  }
  world.put(std::move(wall), stands);
}

/** From the border to the mouth, along the tunnel, and from its end back to the border. */
void addSide(MissionWorld& world, const std::vector<Station>& stations, double half_m, double side)
{
  const SceneExtentParams& e = world.area();
  const double border = side > 0 ? e.max_y_m - 0.5 : e.min_y_m + 0.5;
  const double off = side * (half_m + kWall_m / 2);
  std::vector<Eigen::Vector2d> corners;
  corners.emplace_back(stations.front().beside(off).x(), border);
  for (size_t i = 0; i < stations.size(); i += 2)
  {
    corners.push_back(stations[i].beside(off));
  }
  corners.emplace_back(corners.back().x(), border);
  addWall(world, corners);
}

void addRoof(MissionWorld& world, const std::vector<Station>& stations, double half_m)
{
  constexpr size_t kPiece = 4;  // stations
  for (size_t i = 0; i + kPiece < stations.size(); i += kPiece)
  {
    const Station& middle = stations[i + kPiece / 2];
    ObjectParams slab =
        standingAt(object(ObjectKind::box), middle.at, middle.heading_rad * (180 / geometry::kPi));
    slab.z_m = kHigh_m;
    slab.length_m = kStep_m * kPiece + 0.2;
    slab.width_m = inMillimetres(2 * (half_m + kWall_m));
    slab.height_m = 0.2;
    slab.label = choose(Label::structure);
    slab.material = choose(Material::concrete);
    world.scene().objects.push_back(slab);
  }
}

/** Boxes on the open ground. */
void addBoxes(MissionWorld& world, const std::vector<Station>& stations)
{
  constexpr double kMouth_m = 3;
  constexpr int kTries = 4;  // for each
  Random random = world.randomFor(Purpose::things);
  const SceneExtentParams& e = world.area();
  for (int i = 0; i < world.asks().things * kTries; ++i)
  {
    const double x = random.uniform(e.min_x_m, e.max_x_m);
    const Eigen::Vector2d at(x, random.uniform(e.min_y_m, e.max_y_m));
    ObjectParams box = standingAt(object(ObjectKind::box), at, random.uniform(-180, 180));
    box.length_m = rounded(random, 0.4, 1.2);
    box.width_m = rounded(random, 0.4, 1.2);
    box.height_m = rounded(random, 0.5, 1.5);
    if (x < stations.front().at.x() - kMouth_m || x > stations.back().at.x() + kMouth_m)
    {
      world.putIfFree(box, boxStand(box), 0.5);
    }
  }
}
}  // namespace

void addTunnel(SceneParams& scene, uint64_t seed)
{
  constexpr double kLong_m = 30;
  MissionWorld world(scene, seed, {kLong_m + 2 * kEnd_m + 2, 26});
  world.addRoughness();
  world.addBorder(1.2);
  const std::vector<Station> stations = middleLine(kLong_m, world.randomFor(Purpose::line));
  Random random = world.randomFor(Purpose::width);
  const double narrow = world.asks().corridor_m;
  const double half_m = rounded(random, narrow - 0.3, narrow + 0.3) / 2;
  const bool roofed = random.chance(0.5) && world.asks().overhangs > 0;
  for (const double side : {1.0, -1.0})
  {
    addSide(world, stations, half_m, side);
  }
  if (roofed)
  {
    addRoof(world, stations, half_m);
  }
  Random where = world.randomFor(Purpose::places);
  const double start_y = where.uniform(-4, 4);
  const double goal_y = where.uniform(-4, 4);
  world.setMission({{stations.front().at.x() - 8, start_y}, {stations.back().at.x() + 8, goal_y}});
  world.keepClear(lineBetween(stations.front().ahead(-4), stations.back().ahead(4), 2));
  addBoxes(world, stations);
  world.proposeDrive();
}
}  // namespace traverse::simulation
