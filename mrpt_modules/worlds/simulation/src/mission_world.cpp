// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mission_world.h"

#include <traverse/geometry/convex_distance.h>
#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/footprints.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
constexpr double kInset_m = 0.5;   // of the border wall
constexpr double kAround_m = 1.6;  // of start and goals nothing stands
constexpr double kDegree = geometry::kPi / 180;

double lengthOf(const Eigen::Vector2d& v)
{
  return std::sqrt(v.dot(v));
}

double yawOf(const Eigen::Vector2d& way)
{
  return geometry::angleOf(way.y(), way.x()) / kDegree;
}

/** With its corners not rounded. */
Outline outlineOf(const Stand& stand)
{
  const Eigen::Vector2d x = stand.axis * (stand.half_x_m + stand.round_m);
  const Eigen::Vector2d y =
      Eigen::Vector2d(-stand.axis.y(), stand.axis.x()) * (stand.half_y_m + stand.round_m);
  return {stand.middle - x - y, stand.middle + x - y, stand.middle + x + y, stand.middle - x + y};
}

bool isFreeBetween(const FreeGrid& grid, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const int n = 1 + static_cast<int>(lengthOf(b - a) / (FreeGrid::kCell_m / 2));
  for (int i = 0; i <= n; ++i)
  {
    if (!grid.isFree(a + (b - a) * (static_cast<double>(i) / n)))
    {
      return false;
    }
  }
  return true;
}

/** Straight pieces in place of cells, as long as they are free. */
std::vector<Eigen::Vector2d> straightened(
    const FreeGrid& grid, const std::vector<Eigen::Vector2d>& way)
{
  std::vector<Eigen::Vector2d> corners = {way.front()};
  for (size_t i = 1; i + 1 < way.size(); ++i)
  {
    if (!isFreeBetween(grid, corners.back(), way[i + 1]))
    {
      corners.push_back(way[i]);
    }
  }
  corners.push_back(way.back());
  return corners;
}
}  // namespace

MissionWorld::MissionWorld(SceneParams& scene, uint64_t seed, const Eigen::Vector2d& least_m) :
    scene_(scene),
    asks_(scene.random),
    seed_(mixed({seed, 0x9A9E2007, static_cast<uint64_t>(scene.random.style)})),
    grid_(scene.extent, kVehicleHalf_m + kSpare_m)
{
  const SceneExtentParams& e = scene.extent;
  if (e.max_x_m - e.min_x_m < least_m.x() || e.max_y_m - e.min_y_m < least_m.y())
  {
    throw options::OptionError(
        "style", options::format(asks_.style),
        "where the area of [Scene] has " + options::format(least_m.x()) + " m x " +
            options::format(least_m.y()) + " m and more");
  }
}

void MissionWorld::addBorder(double height_m)
{
  const SceneExtentParams& e = scene_.extent;
  ObjectParams wall = object(ObjectKind::wall);
  wall.x_m = e.min_x_m + kInset_m;
  wall.y_m = e.min_y_m + kInset_m;
  wall.height_m = height_m;
  wall.width_m = kWall_m;
  const double x = e.max_x_m - kInset_m - wall.x_m;
  const double y = e.max_y_m - kInset_m - wall.y_m;
  wall.xs_m = {0, x, x, 0, 0};
  wall.ys_m = {0, 0, y, y, 0};
  std::vector<Stand> stands;
  for (size_t i = 0; i + 1 < wall.xs_m.size(); ++i)
  {
    const Eigen::Vector2d from(wall.x_m + wall.xs_m[i], wall.y_m + wall.ys_m[i]);
    const Eigen::Vector2d to(wall.x_m + wall.xs_m[i + 1], wall.y_m + wall.ys_m[i + 1]);
    stands.push_back(lineBetween(from, to, kWall_m / 2));
  }
  put(std::move(wall), stands);
}

void MissionWorld::addRoughness()
{
  if (asks_.roughness_m > 0)
  {
    Random random = randomFor(0x40063);
    TerrainParams p;
    p.kind = TerrainKind::roughness;
    p.height_m = asks_.roughness_m;
    p.wavelength_m = rounded(random, 0.5, 1);
    p.seed = seedOf(random);
    scene_.terrains.push_back(p);
  }
}

void MissionWorld::setMission(const std::vector<Eigen::Vector2d>& places)
{
  MissionParams& mission = scene_.mission;
  mission = {};
  for (const Eigen::Vector2d& place : places)
  {
    places_.emplace_back(inMillimetres(place.x()), inMillimetres(place.y()));
    clear_.push_back(discAt(places_.back(), kAround_m));
    mission.goal_xs_m.push_back(places_.back().x());
    mission.goal_ys_m.push_back(places_.back().y());
  }
  ways_.assign(places_.size() - 1, {});
  mission.start_x_m = mission.goal_xs_m.front();
  mission.start_y_m = mission.goal_ys_m.front();
  mission.goal_xs_m.erase(mission.goal_xs_m.begin());
  mission.goal_ys_m.erase(mission.goal_ys_m.begin());
  mission.start_yaw_deg = inMillimetres(yawOf(places_[1] - places_[0]));
}

void MissionWorld::put(ObjectParams thing, const std::vector<Stand>& stands)
{
  for (const Stand& stand : stands)
  {
    grid_.block(stand);
    taken_.push_back(stand);
  }
  scene_.objects.push_back(std::move(thing));
}

bool MissionWorld::isFree(const Stand& stand, double gap_m) const
{
  const Outline outline = outlineOf(stand);
  const auto near = [&](double gap)
  {
    return [&, gap](const Stand& other)
    { return geometry::apart(outline, outlineOf(other)) < gap; };
  };
  const SceneExtentParams& e = scene_.extent;
  const bool inside = std::all_of(
      outline.begin(), outline.end(),
      [&](const Eigen::Vector2d& p)
      {
        return p.x() > e.min_x_m + kInset_m && p.x() < e.max_x_m - kInset_m &&
               p.y() > e.min_y_m + kInset_m && p.y() < e.max_y_m - kInset_m;
      });
  return inside && std::none_of(taken_.begin(), taken_.end(), near(gap_m)) &&
         std::none_of(clear_.begin(), clear_.end(), near(0));
}

bool MissionWorld::leavesAWay(const FreeGrid& grid)
{
  for (size_t i = 0; i < ways_.size(); ++i)
  {
    const bool holds =
        !ways_[i].empty() && std::all_of(
                                 ways_[i].begin(), ways_[i].end(),
                                 [&](const Eigen::Vector2d& p) { return grid.isFree(p); });
    std::vector<Eigen::Vector2d> way =
        holds ? std::move(ways_[i]) : grid.way(places_[i], places_[i + 1]);
    ways_[i] = std::move(way);
    if (ways_[i].empty())
    {
      return false;
    }
  }
  return true;
}

bool MissionWorld::putIfFree(ObjectParams thing, const Stand& stand, double gap_m)
{
  if (!isFree(stand, gap_m) || !block({stand}))
  {
    return false;
  }
  scene_.objects.push_back(std::move(thing));
  return true;
}

bool MissionWorld::block(const std::vector<Stand>& stands)
{
  FreeGrid after = grid_;
  for (const Stand& stand : stands)
  {
    after.block(stand);
  }
  if (!leavesAWay(after))
  {
    return false;
  }
  grid_ = std::move(after);
  taken_.insert(taken_.end(), stands.begin(), stands.end());
  return true;
}

void MissionWorld::proposeDrive()
{
  constexpr double kApart_m = 2;
  const auto add = [&](const Eigen::Vector2d& p)
  {
    scene_.drive_xs_m.push_back(inMillimetres(p.x()));
    scene_.drive_ys_m.push_back(inMillimetres(p.y()));
  };
  scene_.drive_xs_m.clear();
  scene_.drive_ys_m.clear();
  add(places_.front());
  for (size_t i = 0; i + 1 < places_.size(); ++i)
  {
    const std::vector<Eigen::Vector2d> way = grid_.way(places_[i], places_[i + 1]);
    if (way.empty())
    {
      throw std::runtime_error("the world has no way through it");
    }
    const std::vector<Eigen::Vector2d> corners = straightened(grid_, way);
    for (size_t k = 0; k + 1 < corners.size(); ++k)
    {
      const Eigen::Vector2d step = corners[k + 1] - corners[k];
      const int n = 1 + static_cast<int>(lengthOf(step) / kApart_m);
      for (int part = 1; part <= n; ++part)
      {
        add(corners[k] + step * (static_cast<double>(part) / n));
      }
    }
  }
}

ObjectParams standingAt(ObjectParams thing, const Eigen::Vector2d& at, double yaw_deg)
{
  thing.x_m = inMillimetres(at.x());
  thing.y_m = inMillimetres(at.y());
  thing.yaw_deg = inMillimetres(std::remainder(yaw_deg, 360));
  return thing;
}

Stand boxStand(const ObjectParams& thing)
{
  const auto [s, c] = geometry::sinCosOf(thing.yaw_deg * kDegree);
  return {
      Eigen::Vector2d(thing.x_m, thing.y_m), Eigen::Vector2d(c, s), thing.length_m / 2,
      thing.width_m / 2, 0};
}

ObjectParams wallBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height_m)
{
  ObjectParams wall = standingAt(object(ObjectKind::wall), from, yawOf(to - from));
  wall.length_m = inMillimetres(lengthOf(to - from));
  wall.width_m = kWall_m;
  wall.height_m = height_m;
  return wall;
}
}  // namespace traverse::simulation
