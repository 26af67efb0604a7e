// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"
#include "refuse.h"
#include "site.h"
#include "strip.h"

#include <cmath>

// What follows the ground along a line: walls and fences.
namespace traverse::simulation
{
namespace
{
constexpr double kFoot_m = 0.2;  // in the ground
constexpr size_t kMostPieces = 20000;

/** The object's line in its own frame: along its x, or its corners. */
std::vector<Segment> lineOf(const ObjectParams& p)
{
  const bool bends = !p.xs_m.empty() || !p.ys_m.empty();
  return bends ? lineThrough(p.xs_m, p.ys_m, "xs_m, ys_m")
               : lineThrough({0, p.length_m}, {0, 0}, "length_m");
}

/** Corners of the line and places between them at most step_m apart, on the ground. */
std::vector<Eigen::Vector3d> stakes(const Site& site, double step_m)
{
  std::vector<Eigen::Vector3d> all;
  const std::vector<Segment> line = lineOf(site.params);
  const auto add = [&](const Eigen::Vector2d& at)
  { all.emplace_back(at.x(), at.y(), site.groundAt(at.x(), at.y())); };
  for (const Segment& s : line)
  {
    const double pieces = std::ceil(s.length_m / step_m);
    if (pieces + static_cast<double>(all.size()) > static_cast<double>(kMostPieces))
    {
      refuse("length_m", lengthOf(line), "20000 pieces at most");
    }
    const auto n = static_cast<int>(pieces);
    for (int i = 0; i < n; ++i)
    {
      add(s.from + s.unit * (s.length_m * i / n));
    }
  }
  add(placeAlong(line, lengthOf(line)));
  return all;
}

Eigen::Vector3d above(const Eigen::Vector3d& place, double height_m)
{
  return {place.x(), place.y(), place.z() + height_m};
}

/** A thin bar as of wire. */
Part wire(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Site& site)
{
  return barPart({from, to, site.params.width_m / 2, site.params.width_m / 2, 4}, site.material);
}

void addPosts(Object& object, const Site& site, const std::vector<Eigen::Vector3d>& posts)
{
  constexpr double kAboveTop_m = 0.05;
  for (const Eigen::Vector3d& post : posts)
  {
    object.parts.push_back(barPart(
        {above(post, -kFoot_m), above(post, site.params.height_m + kAboveTop_m),
         site.params.radius_m, site.params.radius_m, 8},
        site.material));
  }
}

/** Wires between two posts: level ones every 20 cm, upright ones every 10 cm, each its own part, as
 * between them there is air. */
void addMesh(Object& object, const Site& site, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  constexpr double kLevel_m = 0.2;
  constexpr double kUpright_m = 0.1;
  constexpr double kGap_m = 0.04;
  const double height = site.params.height_m;
  const int level = std::max(1, static_cast<int>(std::floor((height - kGap_m) / kLevel_m + 0.5)));
  for (int i = 0; i <= level; ++i)
  {
    const double z = kGap_m + (height - kGap_m) * i / level;
    object.parts.push_back(wire(above(a, z), above(b, z), site));
  }
  const int upright = static_cast<int>((b - a).norm() / kUpright_m);
  for (int i = 1; i < upright; ++i)
  {
    const Eigen::Vector3d foot = a + (b - a) * (static_cast<double>(i) / upright);
    object.parts.push_back(wire(above(foot, kGap_m), above(foot, height), site));
  }
}

/** Upright boards with gaps between two posts, on two rails. */
void addBoards(Object& object, const Site& site, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  constexpr double kBoard_m = 0.12;
  constexpr double kPitch_m = 0.16;
  constexpr double kGround_m = 0.05;
  constexpr double kRail_m = 0.08;
  const double height = site.params.height_m;
  for (const double z : {0.2 * height, 0.75 * height})
  {
    object.parts.push_back(slabPart({above(a, z), above(b, z), 0.04, kRail_m}, site.material));
  }
  const Eigen::Vector3d step = b - a;
  const int n = static_cast<int>(step.norm() / kPitch_m);
  for (int i = 0; i < n; ++i)
  {
    const Eigen::Vector3d from = a + step * (static_cast<double>(i) / n);
    const Eigen::Vector3d to = from + step * (kBoard_m / (kPitch_m * n));
    object.parts.push_back(slabPart(
        {above(from, kGround_m), above(to, kGround_m), site.params.width_m, height - kGround_m},
        site.material));
  }
}
}  // namespace

void addWall(Object& object, const Site& site)
{
  constexpr double kPiece_m = 1;
  const std::vector<Eigen::Vector3d> line = stakes(site, kPiece_m);
  for (size_t i = 0; i + 1 < line.size(); ++i)
  {
    object.parts.push_back(slabPart(
        {above(line[i], -kFoot_m), above(line[i + 1], -kFoot_m), site.params.width_m,
         site.params.height_m + kFoot_m},
        site.material));
  }
}

void addFence(Object& object, const Site& site)
{
  constexpr double kSpan_m = 2.5;
  const std::vector<Eigen::Vector3d> posts = stakes(site, kSpan_m);
  addPosts(object, site, posts);
  for (size_t i = 0; i + 1 < posts.size(); ++i)
  {
    if (site.params.kind == ObjectKind::fence_wire)
    {
      addMesh(object, site, posts[i], posts[i + 1]);
    }
    else
    {
      addBoards(object, site, posts[i], posts[i + 1]);
    }
  }
}
}  // namespace traverse::simulation
