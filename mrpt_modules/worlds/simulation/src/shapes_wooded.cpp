// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"
#include "site.h"

#include <algorithm>
#include <cmath>

// Trees and bushes: bars of wood, each a part of its own, and loose leaves.
namespace traverse::simulation
{
namespace
{
constexpr double kRoot_m = 0.3;
constexpr double kTurn = 2 * geometry::kPi;

/** A direction of length 1, as likely as any other. */
Eigen::Vector3d anyDirection(Random& random)
{
  const double z = random.uniform(-1, 1);
  const auto [s, c] = geometry::sinCosOf(random.uniform(0, 2 * geometry::kPi));
  const double r = std::sqrt(1 - z * z);
  return {r * c, r * s, z};
}

/** A triangle of the size of a hand, turned anyhow. */
void addLeaf(Part& leaves, const Eigen::Vector3d& at, double size_m, Random& random)
{
  const Eigen::Vector3d u = anyDirection(random);
  const Eigen::Vector3d other = u.cross(anyDirection(random));
  const double length = std::sqrt(other.dot(other));
  const Eigen::Vector3d v =
      length > 1e-6 ? Eigen::Vector3d(other / length) : Eigen::Vector3d(0, 0, 0);
  addSheet(
      leaves, at - u * (size_m / 2) - v * (size_m / 3), at + u * (size_m / 2) - v * (size_m / 3),
      at + v * (size_m * 2 / 3));
}

Part looseLeaves()
{
  Part leaves;
  leaves.material = Material::foliage;
  leaves.solid = false;
  return leaves;
}

Part branch(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_m, int sides)
{
  return barPart({from, to, radius_m, radius_m * 0.4, sides}, Material::wood);
}

Eigen::Vector3d outward(double turn_rad, double out_m, double up_m)
{
  const auto [s, c] = geometry::sinCosOf(turn_rad);
  return {c * out_m, s * out_m, up_m};
}

/** A branch with three twigs and its share of the leaves around them. */
void addLimb(
    Object& object,
    Part& leaves,
    const Site& site,
    const Eigen::Vector3d& from,
    const Eigen::Vector3d& reach,
    Random& random)
{
  const ObjectParams& p = site.params;
  constexpr int kTwigs = 3;
  const double length = reach.norm();
  object.parts.push_back(branch(from, from + reach, p.radius_m * 0.3, 6));
  for (int twig = 0; twig < kTwigs; ++twig)
  {
    const Eigen::Vector3d root = from + reach * random.uniform(0.4, 0.95);
    Eigen::Vector3d way = reach / length + 0.9 * anyDirection(random);
    way.z() = std::max(way.z(), 0.05);
    const Eigen::Vector3d tip = root + way * (0.3 * length);
    object.parts.push_back(branch(root, tip, p.radius_m * 0.12, 5));
  }
  const double spread = std::max(0.25, 0.3 * length);
  const int count = p.count / 12;
  for (int leaf = 0; leaf < count; ++leaf)
  {
    Eigen::Vector3d at = from + reach * random.uniform(0.35, 1.1);
    const double away = spread * random.uniform();
    at += away * anyDirection(random);
    // nothing hangs lower than the tree says
    at.z() = std::max(at.z(), p.branch_height_m + 0.1);
    addLeaf(leaves, at, random.uniform(0.08, 0.16), random);
  }
}
}  // namespace

void addTree(Object& object, const Site& site)
{
  constexpr int kLimbs = 11;
  const ObjectParams& p = site.params;
  const double top = std::max(p.height_m, p.branch_height_m + 0.5);
  object.parts.push_back(barPart(
      {{0, 0, -kRoot_m}, {0, 0, top * 0.93}, p.radius_m, p.radius_m * 0.25, 12}, Material::wood));
  Part leaves = looseLeaves();
  for (int limb = 0; limb < kLimbs; ++limb)
  {
    Random random = site.random(static_cast<uint64_t>(limb));
    const double share = (limb + 0.5) / kLimbs;
    const double low = p.branch_height_m + 0.25;
    const double from_z = low + (top * 0.9 - low) * share;
    // widest a third of the way up the crown
    const double wide = share < 0.35 ? 0.7 + 0.3 * share / 0.35 : 1 - 0.7 * (share - 0.35) / 0.65;
    const double turn = 2.4 * limb + random.uniform(-0.4, 0.4);
    const double out = p.width_m / 2 * wide * random.uniform(0.75, 1);
    const double up = out * random.uniform(0.1, 0.5);
    addLimb(object, leaves, site, {0, 0, from_z}, outward(turn, out, up), random);
  }
  if (p.branch_m > 0)
  {
    Random random = site.random(1000);
    const double low = p.branch_height_m + 0.15;
    addLimb(object, leaves, site, {0, 0, low}, {p.branch_m, 0, 0.05 * p.branch_m}, random);
  }
  object.parts.push_back(std::move(leaves));
}

void addBush(Object& object, const Site& site)
{
  constexpr int kStems = 9;
  const ObjectParams& p = site.params;
  Random random = site.random(0);
  const double half = p.width_m / 2;
  for (int stem = 0; stem < kStems; ++stem)
  {
    // one draw a statement: the order within one is the compiler's choice
    const double turn = random.uniform(0, kTurn);
    const Eigen::Vector3d foot = outward(turn, 0.3 * half * random.uniform(), 0);
    const Eigen::Vector3d root(foot.x(), foot.y(), site.groundAt(foot.x(), foot.y()) - 0.1);
    const double lean = random.uniform(0, kTurn);
    const double out = half * random.uniform(0.2, 0.8);
    const Eigen::Vector3d tip = outward(lean, out, p.height_m * random.uniform(0.6, 0.95));
    object.parts.push_back(barPart({root, tip, 0.012, 0.005, 5}, Material::wood));
  }
  Part leaves = looseLeaves();
  leaves.material = site.material;
  for (int leaf = 0; leaf < p.count; ++leaf)
  {
    // evenly over a round body that narrows to half at the ground
    const double share = random.uniform();
    const double wide = std::sqrt(std::max(0.0, 1 - (share * 1.6 - 0.6) * (share * 1.6 - 0.6)));
    const double turn = random.uniform(0, kTurn);
    const Eigen::Vector3d out = outward(turn, half * wide * std::sqrt(random.uniform()), 0);
    const double ground = site.groundAt(out.x(), out.y());
    addLeaf(
        leaves, {out.x(), out.y(), ground + 0.04 + share * (p.height_m - 0.08)},
        random.uniform(0.05, 0.1), random);
  }
  object.parts.push_back(std::move(leaves));
}
}  // namespace traverse::simulation
