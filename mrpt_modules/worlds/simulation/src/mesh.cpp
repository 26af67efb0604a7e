// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/geometry/outline.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace traverse::simulation
{
namespace
{
using geometry::turnOf;

double signedArea(const std::vector<Eigen::Vector2d>& outline)
{
  double sum = 0;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& p = outline[i];
    const Eigen::Vector2d& q = outline[(i + 1) % outline.size()];
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return sum / 2;
}

bool cutEachOther(
    const Eigen::Vector2d& a,
    const Eigen::Vector2d& b,
    const Eigen::Vector2d& c,
    const Eigen::Vector2d& d)
{
  return turnOf(a, b, c) * turnOf(a, b, d) <= 0 && turnOf(c, d, a) * turnOf(c, d, b) <= 0;
}

bool isInTriangle(
    const Eigen::Vector2d& p,
    const Eigen::Vector2d& a,
    const Eigen::Vector2d& b,
    const Eigen::Vector2d& c)
{
  return turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 && turnOf(c, a, p) >= 0;
}

/** True where the corner i of `left` sticks out and its triangle holds no other corner. */
bool isEar(const std::vector<Eigen::Vector2d>& outline, const std::vector<uint32_t>& left, size_t i)
{
  const uint32_t before = left[(i + left.size() - 1) % left.size()];
  const uint32_t after = left[(i + 1) % left.size()];
  const Eigen::Vector2d& a = outline[before];
  const Eigen::Vector2d& b = outline[left[i]];
  const Eigen::Vector2d& c = outline[after];
  return turnOf(a, b, c) > 0 && std::none_of(
                                    left.begin(), left.end(),
                                    [&](uint32_t k) {
                                      return k != before && k != left[i] && k != after &&
                                             isInTriangle(outline[k], a, b, c);
                                    });
}

/** By cutting off ears; outline counter-clockwise. */
std::vector<std::array<uint32_t, 3>> triangulated(const std::vector<Eigen::Vector2d>& outline)
{
  std::vector<uint32_t> left(outline.size());
  std::iota(left.begin(), left.end(), 0U);
  std::vector<std::array<uint32_t, 3>> triangles;
  triangles.reserve(outline.size());
  while (left.size() > 3)
  {
    size_t ear = 0;
    while (ear + 1 < left.size() && !isEar(outline, left, ear))
    {
      ++ear;
    }
    triangles.push_back(
        {left[(ear + left.size() - 1) % left.size()], left[ear], left[(ear + 1) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

/** The sides between two rings of n corners, the lower one first among the vertices. */
void joinRings(Part& part, uint32_t n)
{
  for (uint32_t i = 0; i < n; ++i)
  {
    const uint32_t j = (i + 1) % n;
    part.triangles.push_back({i, j, n + j});
    part.triangles.push_back({i, n + j, n + i});
  }
}

Eigen::Vector3d across(const Eigen::Vector3d& axis)
{
  const bool upright = std::abs(axis.z()) > 0.9 * axis.norm();
  const Eigen::Vector3d other = upright ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d side = other.cross(axis);
  return side / std::sqrt(side.dot(side));
}
}  // namespace

bool isSimple(const std::vector<Eigen::Vector2d>& outline)
{
  const size_t n = outline.size();
  if (n < 3 || !(std::abs(signedArea(outline)) > 1e-9))
  {
    return false;
  }
  for (size_t i = 0; i < n; ++i)
  {
    for (size_t j = i + 2; j < n; ++j)
    {
      const bool neighbours = i == 0 && j + 1 == n;
      if (!neighbours &&
          cutEachOther(outline[i], outline[(i + 1) % n], outline[j], outline[(j + 1) % n]))
      {
        return false;
      }
    }
  }
  return true;
}

Part loftPart(
    const std::vector<Eigen::Vector3d>& lower,
    const std::vector<Eigen::Vector3d>& upper,
    Material material)
{
  Part part;
  part.material = material;
  const auto n = static_cast<uint32_t>(lower.size());
  part.vertices.reserve(2 * lower.size());
  for (const Eigen::Vector3d& p : lower)
  {
    part.vertices.emplace_back(p.cast<float>());
  }
  for (const Eigen::Vector3d& p : upper)
  {
    part.vertices.emplace_back(p.cast<float>());
  }
  joinRings(part, n);
  for (uint32_t i = 1; i + 1 < n; ++i)
  {
    part.triangles.push_back({0, i + 1, i});
    part.triangles.push_back({n, n + i, n + i + 1});
  }
  return part;
}

Part boxPart(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Material material)
{
  return prismPart(
      {{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}}, low.z(),
      high.z(), material);
}

Part prismPart(
    const std::vector<Eigen::Vector2d>& outline, double bottom_m, double top_m, Material material)
{
  std::vector<Eigen::Vector2d> ring = outline;
  if (signedArea(ring) < 0)
  {
    std::reverse(ring.begin(), ring.end());
  }
  Part part;
  part.material = material;
  const auto n = static_cast<uint32_t>(ring.size());
  part.vertices.reserve(2 * ring.size());
  for (const double z : {bottom_m, top_m})
  {
    for (const Eigen::Vector2d& p : ring)
    {
      part.vertices.emplace_back(Eigen::Vector3d(p.x(), p.y(), z).cast<float>());
    }
  }
  joinRings(part, n);
  for (const auto& [a, b, c] : triangulated(ring))
  {
    part.triangles.push_back({a, c, b});
    part.triangles.push_back({n + a, n + b, n + c});
  }
  return part;
}

Part barPart(const Bar& bar, Material material)
{
  const Eigen::Vector3d axis = bar.to - bar.from;
  const Eigen::Vector3d u = across(axis);
  const Eigen::Vector3d w = axis.cross(u);
  const Eigen::Vector3d v = w / std::sqrt(w.dot(w));
  std::vector<Eigen::Vector3d> lower;
  std::vector<Eigen::Vector3d> upper;
  lower.reserve(static_cast<size_t>(bar.sides));
  upper.reserve(static_cast<size_t>(bar.sides));
  for (int i = 0; i < bar.sides; ++i)
  {
    const auto [s, c] = geometry::sinCosOf(2 * geometry::kPi * i / bar.sides);
    const Eigen::Vector3d out = c * u + s * v;
    lower.emplace_back(bar.from + bar.from_radius_m * out);
    upper.emplace_back(bar.to + bar.to_radius_m * out);
  }
  return loftPart(lower, upper, material);
}

Part slabPart(const Slab& slab, Material material)
{
  const double dx = slab.b.x() - slab.a.x();
  const double dy = slab.b.y() - slab.a.y();
  const double length = std::sqrt(dx * dx + dy * dy);
  const double half = slab.thickness_m / 2;
  const Eigen::Vector3d left(-dy / length * half, dx / length * half, 0);
  const Eigen::Vector3d up(0, 0, slab.height_m);
  const std::vector<Eigen::Vector3d> lower = {
      slab.a - left, slab.b - left, slab.b + left, slab.a + left};
  const std::vector<Eigen::Vector3d> upper = {
      lower[0] + up, lower[1] + up, lower[2] + up, lower[3] + up};
  return loftPart(lower, upper, material);
}

void addSheet(
    Part& part, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const auto first = static_cast<uint32_t>(part.vertices.size());
  for (const Eigen::Vector3d* p : {&a, &b, &c})
  {
    part.vertices.emplace_back(p->cast<float>());
  }
  part.triangles.push_back({first, first + 1, first + 2});
}

void place(Part& part, double yaw_rad, const Eigen::Vector3d& to)
{
  const auto [s, c] = geometry::sinCosOf(yaw_rad);
  for (Eigen::Vector3f& vertex : part.vertices)
  {
    const Eigen::Vector3d p = vertex.cast<double>();
    vertex =
        (Eigen::Vector3d(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()) + to).cast<float>();
  }
}
}  // namespace traverse::simulation
