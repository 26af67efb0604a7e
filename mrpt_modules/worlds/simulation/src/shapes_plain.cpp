// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"
#include "refuse.h"
#include "site.h"

#include <algorithm>

namespace traverse::simulation
{
namespace
{
constexpr double kFoundation_m = 0.3;
constexpr int kRoundSides = 48;

/** The lowest ground under the corners and the middle, less a foundation; a thing that hangs above
 * the ground has none. */
double bottomOf(const Site& site, const std::vector<Eigen::Vector2d>& outline)
{
  if (site.params.z_m != 0)
  {
    return 0;
  }
  double lowest = 0;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d middle = (a + outline[(i + 1) % outline.size()]) / 2;
    lowest = std::min({lowest, site.groundAt(a.x(), a.y()), site.groundAt(middle.x(), middle.y())});
  }
  return lowest - kFoundation_m;
}

std::vector<Eigen::Vector2d> rectangle(double length_m, double width_m)
{
  const double x = length_m / 2;
  const double y = width_m / 2;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

void addUpright(Object& object, const Site& site, const std::vector<Eigen::Vector2d>& outline)
{
  object.parts.push_back(
      prismPart(outline, bottomOf(site, outline), site.params.height_m, site.material));
}

void addPrism(Object& object, const Site& site)
{
  const ObjectParams& p = site.params;
  std::vector<Eigen::Vector2d> outline;
  outline.reserve(p.xs_m.size());
  for (size_t i = 0; i < std::min(p.xs_m.size(), p.ys_m.size()); ++i)
  {
    outline.emplace_back(p.xs_m[i], p.ys_m[i]);
  }
  constexpr size_t kMostCorners = 500;
  if (p.xs_m.size() != p.ys_m.size() || outline.size() > kMostCorners || !isSimple(outline))
  {
    throw options::OptionError(
        "xs_m, ys_m", options::format(p.xs_m) + ", " + options::format(p.ys_m),
        "an outline of 3 to 500 corners that does not cross itself, as many x as y");
  }
  addUpright(object, site, outline);
}

/** An upright bar whose foot is in the ground. */
Bar post(double x_m, double y_m, double bottom_m, double top_m, double radius_m, int sides)
{
  return {{x_m, y_m, bottom_m}, {x_m, y_m, top_m}, radius_m, radius_m, sides};
}

void addRound(Object& object, const Site& site, int sides)
{
  const ObjectParams& p = site.params;
  const double bottom = p.z_m != 0 ? 0 : bottomOf(site, rectangle(2 * p.radius_m, 2 * p.radius_m));
  object.parts.push_back(barPart(post(0, 0, bottom, p.height_m, p.radius_m, sides), site.material));
}

/** Deck with two walls of its own that carry it. */
void addBridge(Object& object, const Site& site)
{
  constexpr double kDeck_m = 0.5;
  constexpr double kPier_m = 0.6;
  const ObjectParams& p = site.params;
  const double x = p.length_m / 2;
  const double y = p.width_m / 2;
  object.parts.push_back(
      boxPart({-x, -y, p.height_m}, {x, y, p.height_m + kDeck_m}, site.material));
  for (const double from : {-x, x - kPier_m})
  {
    const double ground =
        std::min(site.groundAt(from, -y), site.groundAt(from + kPier_m, y)) - kFoundation_m;
    object.parts.push_back(
        boxPart({from, -y, ground}, {from + kPier_m, y, p.height_m}, site.material));
  }
}

void addGate(Object& object, const Site& site)
{
  const ObjectParams& p = site.params;
  const double y = p.width_m / 2;
  const double beam = 2 * p.radius_m;
  for (const double side : {-y, y})
  {
    const double ground = site.groundAt(0, side) - kFoundation_m;
    object.parts.push_back(
        barPart(post(0, side, ground, p.height_m, p.radius_m, 12), site.material));
  }
  object.parts.push_back(boxPart(
      {-p.radius_m, -y - p.radius_m, p.height_m}, {p.radius_m, y + p.radius_m, p.height_m + beam},
      site.material));
}

void addTable(Object& object, const Site& site)
{
  constexpr double kPlate_m = 0.04;
  constexpr double kLeg_m = 0.03;
  const ObjectParams& p = site.params;
  const double x = p.length_m / 2;
  const double y = p.width_m / 2;
  object.parts.push_back(
      boxPart({-x, -y, p.height_m - kPlate_m}, {x, y, p.height_m}, site.material));
  for (const auto& [sx, sy] :
       {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
  {
    const double at_x = sx * (x - 2 * kLeg_m);
    const double at_y = sy * (y - 2 * kLeg_m);
    const double ground = site.groundAt(at_x, at_y);
    object.parts.push_back(
        barPart(post(at_x, at_y, ground - 0.02, p.height_m - kPlate_m, kLeg_m, 8), site.material));
  }
}
}  // namespace

void addPlainShape(Object& object, const Site& site)
{
  const ObjectParams& p = site.params;
  switch (p.kind)
  {
    case ObjectKind::box:
      return addUpright(object, site, rectangle(p.length_m, p.width_m));
    case ObjectKind::prism:
      return addPrism(object, site);
    case ObjectKind::cylinder:
      return addRound(object, site, kRoundSides);
    case ObjectKind::pole:
      return addRound(object, site, 12);
    case ObjectKind::bridge:
      return addBridge(object, site);
    case ObjectKind::gate:
      return addGate(object, site);
    case ObjectKind::table:
      return addTable(object, site);
    default:
      object.balls.push_back(
          {Eigen::Vector3f::Zero(), static_cast<float>(p.radius_m), site.material});
  }
}

void addBuilding(Object& object, const Site& site)
{
  constexpr double kEaves_m = 0.3;
  constexpr double kRidge_m = 0.05;
  constexpr double kSteepness = 0.6;
  const ObjectParams& p = site.params;
  addUpright(object, site, rectangle(p.length_m, p.width_m));
  const double x = p.length_m / 2 + kEaves_m;
  const double y = p.width_m / 2 + kEaves_m;
  const double z = p.height_m;
  const double ridge = z + y * kSteepness;
  object.parts.push_back(loftPart(
      {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}},
      {{-x, -kRidge_m, ridge}, {x, -kRidge_m, ridge}, {x, kRidge_m, ridge}, {-x, kRidge_m, ridge}},
      Material::brick));
}
}  // namespace traverse::simulation
