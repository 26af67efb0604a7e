// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper_5.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <tuple>

namespace traverse::simulation
{
namespace
{
using Corners = std::pair<std::vector<double>, std::vector<double>>;

enum Purpose : uint64_t
{
  way = 1,
  road,
  ditches,
  holes,
  overhangs
};

constexpr double kStep_m = 2;
constexpr double kBeyond_m = 36;  //!< the road goes on so far behind both ends of the drive

/** A line that bends left and right and comes back to the x axis; its tightest bends have 20 to 90
 * m of radius, some streets' are wide. */
Corners windingLine(double length_m, Random random)
{
  constexpr double kSteepest_rad = 0.8;
  constexpr double kLongestBend_m = 35;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double heading = 0;
  double aim = 0;
  double bend = 0;
  double straight_m = random.uniform(10, 30);
  const double tightest_m = random.uniform(20, 90);
  std::vector<Eigen::Vector2d> line = {at};
  for (int i = 0; i < static_cast<int>(length_m / kStep_m); ++i)
  {
    const double left = aim - heading;
    if (std::abs(left) > bend * kStep_m && bend > 0)
    {
      heading += left > 0 ? bend * kStep_m : -bend * kStep_m;
    }
    else if (straight_m > 0)
    {
      straight_m -= kStep_m;
    }
    else
    {
      const double radius_m = random.uniform(tightest_m, 2 * tightest_m);
      const double back = at.y() > 0 ? -1 : 1;
      aim = back * random.uniform(0.3, 1) * std::min(kSteepest_rad, kLongestBend_m / radius_m);
      bend = 1 / radius_m;
      straight_m = random.uniform(8, 30);
    }
    const auto [s, c] = geometry::sinCosOf(heading);
    at += kStep_m * Eigen::Vector2d(c, s);
    line.push_back(at);
  }
  Corners corners;
  for (const Eigen::Vector2d& p : line)
  {
    corners.first.push_back(inMillimetres(p.x() - at.x() / 2));
    corners.second.push_back(inMillimetres(p.y()));
  }
  return corners;
}

TerrainParams terrain(TerrainKind kind)
{
  TerrainParams p;
  p.kind = kind;
  return p;
}
}  // namespace

Paper5::Paper5(SceneParams& scene, uint64_t seed) :
    scene_(scene),
    asks_(scene.random),
    seed_(mixed({seed, 0x9A9E2005})),
    half_m_(scene.random.drive_m / 2),
    way_(windingLine(scene.random.drive_m + 2 * kBeyond_m, randomFor(Purpose::way))),
    plot_(scene_.extent, way_)
{
}

void Paper5::addAll()
{
  std::tie(scene_.drive_xs_m, scene_.drive_ys_m) = way_.beside(-half_m_, half_m_, 0);
  checkDrive(scene_);
  addGround();
  addTraffic();
  addOverhangs();
  addDitches();
  addHoles();
  addParkedVehicles();
  addBuildings();
  addWalls();
  addSmallThings();
  addPeople();
  scene_.random = {};
}

void Paper5::addGround()
{
  Random random = randomFor(Purpose::road);
  const auto add = [&](TerrainKind kind, double height_m, double wavelength_m)
  {
    TerrainParams p = terrain(kind);
    p.height_m = inMillimetres(height_m);
    p.wavelength_m = inMillimetres(wavelength_m);
    p.seed = seedOf(random);
    if (p.height_m > 0)
    {
      scene_.terrains.push_back(p);
    }
  };
  const double high = asks_.hill_height_m * random.uniform(0.2, 1);
  add(TerrainKind::hills, high, random.uniform(40, 70));
  add(TerrainKind::roughness, asks_.roughness_m, random.uniform(0.4, 1));
  half_road_m_ = rounded(random, 4.2, 5.5);
  TerrainParams p = terrain(TerrainKind::road);
  std::tie(p.xs_m, p.ys_m) = way_.beside(-way_.half_m(), way_.half_m(), 0);
  p.width_m = 2 * half_road_m_;
  p.height_m = rounded(random, 0.01, 0.08);
  scene_.terrains.push_back(p);
  for (const double side : {1.0, -1.0})
  {
    const double width = rounded(random, 1.5, 2.5);
    const double high_m = rounded(random, 0.08, 0.13);
    if (random.chance(asks_.kerb_chance))
    {
      TerrainParams kerb = terrain(TerrainKind::kerb);
      std::tie(kerb.xs_m, kerb.ys_m) =
          way_.beside(-way_.half_m(), way_.half_m(), side * (half_road_m_ + width / 2));
      kerb.width_m = width;
      kerb.height_m = high_m;
      scene_.terrains.push_back(kerb);
    }
  }
}

void Paper5::addDitches()
{
  constexpr double kTried_m = 22;  // on either side of the drive, in stretches
  Random random = randomFor(Purpose::ditches);
  for (int i = 0; i < static_cast<int>(2 * half_m_ / kTried_m); ++i)
  {
    const double from = -half_m_ + kTried_m * i;
    const bool along = random.chance(0.5);
    const double off = half_road_m_ + random.uniform(3, 5.5);
    const double left = side(random) * off;
    const double length = random.uniform(8, 16);
    TerrainParams p = terrain(TerrainKind::ditch);
    p.width_m = rounded(random, 0.7, 1.6);
    p.height_m = rounded(random, 0.45, 1);
    p.edge_m = rounded(random, 0.05, 0.25);
    if (along)
    {
      std::tie(p.xs_m, p.ys_m) = way_.beside(from, from + length, left);
    }
    else
    {
      for (const double further : {0.0, length / 2})
      {
        const Eigen::Vector2d at = way_.place(from, left + (left > 0 ? further : -further));
        p.xs_m.push_back(inMillimetres(at.x()));
        p.ys_m.push_back(inMillimetres(at.y()));
      }
    }
    const std::vector<Disc> discs = discsAlong(p.xs_m, p.ys_m, p.width_m / 2 + 0.4);
    if (random.chance(asks_.ditch_chance) && plot_.areFree(discs, half_road_m_ + 1))
    {
      plot_.take(discs);
      scene_.terrains.push_back(p);
    }
  }
}

void Paper5::addHoles()
{
  constexpr int kTries = 40;
  Random random = randomFor(Purpose::holes);
  const int n = about(asks_.holes, random);
  for (int i = 0; i < n; ++i)
  {
    TerrainParams p = terrain(TerrainKind::hole);
    p.width_m = rounded(random, 0.9, 1.8);
    p.height_m = rounded(random, 0.45, 1);
    const double radius = p.width_m / 2 + 0.4;
    for (int attempt = 0; attempt < kTries; ++attempt)
    {
      const double off = half_road_m_ + 0.4 + radius + random.uniform(0, 5);
      const double along = anywhere(random);
      const Eigen::Vector2d at = way_.place(along, side(random) * off);
      if (plot_.isFree({at, radius}, half_road_m_))
      {
        plot_.take({at, radius});
        p.x_m = inMillimetres(at.x());
        p.y_m = inMillimetres(at.y());
        scene_.terrains.push_back(p);
        break;
      }
    }
  }
}

void Paper5::addOverhangs()
{
  Random random = randomFor(Purpose::overhangs);
  const int n = about(asks_.overhangs, random);
  for (int i = 0; i < n; ++i)
  {
    ObjectParams p;
    const double along = anywhere(random);
    const Eigen::Vector2d at = way_.place(along, 0);
    const double across = inMillimetres(2 * half_road_m_ + random.uniform(5.5, 8));
    const bool bridge = random.chance(0.5);
    p.kind = bridge ? ObjectKind::bridge : ObjectKind::gate;
    p.x_m = inMillimetres(at.x());
    p.y_m = inMillimetres(at.y());
    p.height_m = rounded(random, 2.6, 4.5);
    // a bridge's x axis and a gate's y axis are across the road
    p.yaw_deg = inMillimetres(std::remainder(way_.yawDeg(along) + (bridge ? 90 : 0), 360));
    const double deep = rounded(random, 2, 9);
    (bridge ? p.length_m : p.width_m) = across;
    if (bridge)
    {
      p.width_m = deep;
    }
    const double pier = bridge ? deep / 2 + 0.6 : 0.5;
    for (const double end : {across / 2, -across / 2})
    {
      plot_.take({way_.place(along, end), pier});
    }
    scene_.objects.push_back(p);
  }
}
}  // namespace traverse::simulation
