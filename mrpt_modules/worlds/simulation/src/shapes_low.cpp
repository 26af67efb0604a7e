// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"
#include "refuse.h"
#include "site.h"

#include <algorithm>
#include <array>
#include <cmath>

// What covers the ground: grass and lumps.
namespace traverse::simulation
{
namespace
{
constexpr double kMostBlades = 2e6;

Eigen::Vector3d turned(double yaw_rad, double x_m)
{
  const auto [s, c] = geometry::sinCosOf(yaw_rad);
  return {c * x_m, s * x_m, 0};
}

/** A thin tall triangle on the ground that leans to a side. */
void addBlade(Part& patch, const Site& site, const Eigen::Vector2d& at, Random& random)
{
  constexpr double kRoot_m = 0.01;
  const double height = site.params.height_m * random.uniform(0.5, 1);
  const double half = random.uniform(0.0015, 0.003);
  const double turn = random.uniform(0, 2 * geometry::kPi);
  const double lean = height * random.uniform(0, 0.4);
  const Eigen::Vector3d foot(at.x(), at.y(), site.groundAt(at.x(), at.y()) - kRoot_m);
  const Eigen::Vector3d side = turned(turn, half);
  const Eigen::Vector3d tip =
      foot + turned(turn + geometry::kPi / 2, lean) + Eigen::Vector3d(0, 0, height + kRoot_m);
  addSheet(patch, foot - side, foot + side, tip);
}

/** Where the columns or rows of patches of about 1 m end. */
int patchesAlong(double length_m)
{
  return std::max(1, static_cast<int>(std::floor(length_m + 0.5)));
}

/** A half-ellipsoid that is not quite regular, on the ground, closed below it. */
Part lump(const Site& site, Random random)
{
  constexpr uint32_t kSides = 7;
  constexpr double kBelow_m = 0.04;
  constexpr std::array<std::array<double, 2>, 3> kRings = {
      {{1, -1}, {0.85, 0.45}, {0.4, 0.9}}};  // share of the radius, of the height
  const ObjectParams& p = site.params;
  const double x = random.uniform(-0.5, 0.5) * p.length_m;
  const double y = random.uniform(-0.5, 0.5) * p.width_m;
  const double rx = p.radius_m * random.uniform(0.35, 1);
  const double ry = rx * random.uniform(0.6, 1);
  const double height = p.height_m * random.uniform(0.5, 1);
  const double turn = random.uniform(0, 2 * geometry::kPi);
  const double ground = site.groundAt(x, y);
  Part part;
  part.material = site.material;
  const auto add = [&](double dx, double dy, double z)
  { part.vertices.emplace_back(Eigen::Vector3d(dx, dy, z).cast<float>()); };
  for (const auto& [share, up] : kRings)
  {
    for (uint32_t i = 0; i < kSides; ++i)
    {
      const auto [s, c] = geometry::sinCosOf(2 * geometry::kPi * i / kSides);
      const double r = share * random.uniform(0.85, 1.15);
      add(r * rx * c, r * ry * s, up < 0 ? -kBelow_m : up * height);
    }
  }
  add(0, 0, height);
  for (uint32_t ring = 0; ring < 2; ++ring)
  {
    for (uint32_t i = 0; i < kSides; ++i)
    {
      const uint32_t a = ring * kSides + i;
      const uint32_t b = ring * kSides + (i + 1) % kSides;
      part.triangles.push_back({a, b, b + kSides});
      part.triangles.push_back({a, b + kSides, a + kSides});
    }
  }
  for (uint32_t i = 0; i < kSides; ++i)
  {
    part.triangles.push_back({2 * kSides + i, 2 * kSides + (i + 1) % kSides, 3 * kSides});
  }
  for (uint32_t i = 1; i + 1 < kSides; ++i)
  {
    part.triangles.push_back({0, i + 1, i});
  }
  place(part, turn, {x, y, ground});
  return part;
}
}  // namespace

void addGrass(Object& object, const Site& site)
{
  const ObjectParams& p = site.params;
  if (p.length_m * p.width_m * p.count > kMostBlades)
  {
    refuse("count", p.count, "2 million blades in all");
  }
  const int columns = patchesAlong(p.length_m);
  const int rows = patchesAlong(p.width_m);
  const double dx = p.length_m / columns;
  const double dy = p.width_m / rows;
  const int blades = static_cast<int>(std::floor(dx * dy * p.count + 0.5));
  for (int i = 0; i < columns * rows; ++i)
  {
    Random random = site.random(static_cast<uint64_t>(i));
    const int row = i / columns;
    const Eigen::Vector2d corner(-p.length_m / 2 + dx * (i % columns), -p.width_m / 2 + dy * row);
    Part patch;
    patch.material = site.material;
    patch.solid = false;
    for (int blade = 0; blade < blades; ++blade)
    {
      const double x = corner.x() + random.uniform(0, dx);
      addBlade(patch, site, {x, corner.y() + random.uniform(0, dy)}, random);
    }
    object.parts.push_back(std::move(patch));
  }
}

void addLumps(Object& object, const Site& site)
{
  constexpr int kMostLumps = 20000;
  if (site.params.count > kMostLumps)
  {
    refuse("count", site.params.count, "20000 lumps at most");
  }
  for (int i = 0; i < site.params.count; ++i)
  {
    object.parts.push_back(lump(site, site.random(static_cast<uint64_t>(i))));
  }
}
}  // namespace traverse::simulation
