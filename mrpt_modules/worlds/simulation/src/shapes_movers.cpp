// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"
#include "site.h"

// Cars and people.
namespace traverse::simulation
{
void addVehicle(Object& object, const Site& site)
{
  constexpr double kWheel_m = 0.31;
  constexpr double kTyre_m = 0.2;
  constexpr double kFree_m = 0.2;
  const ObjectParams& p = site.params;
  const double x = p.length_m / 2;
  const double y = p.width_m / 2;
  const double bonnet = kFree_m + 0.5 * (p.height_m - kFree_m);
  object.parts.push_back(boxPart({-x, -y, kFree_m}, {x, y, bonnet}, site.material));
  const double in = y - 0.12;
  object.parts.push_back(loftPart(
      {{-0.9 * x, -y + 0.02, bonnet},
       {0.42 * x, -y + 0.02, bonnet},
       {0.42 * x, y - 0.02, bonnet},
       {-0.9 * x, y - 0.02, bonnet}},
      {{-0.7 * x, -in, p.height_m},
       {0.15 * x, -in, p.height_m},
       {0.15 * x, in, p.height_m},
       {-0.7 * x, in, p.height_m}},
      Material::glass));
  for (const double wheel_x : {-0.6 * x, 0.62 * x})
  {
    for (const double from : {-y, y - kTyre_m})
    {
      object.parts.push_back(barPart(
          {{wheel_x, from, kWheel_m}, {wheel_x, from + kTyre_m, kWheel_m}, kWheel_m, kWheel_m, 16},
          Material::asphalt));
    }
  }
}

void addPerson(Object& object, const Site& site)
{
  const double h = site.params.height_m;
  const double hip = 0.48 * h;
  const double shoulder = 0.82 * h;
  for (const double side : {-1.0, 1.0})
  {
    object.parts.push_back(barPart(
        {{0.02 * side, 0.09 * side, 0}, {0, 0.08 * side, hip}, 0.06, 0.085, 10}, site.material));
    object.parts.push_back(barPart(
        {{0.06 * side, 0.26 * side, 0.42 * h}, {0, 0.21 * side, shoulder}, 0.035, 0.05, 8},
        site.material));
  }
  object.parts.push_back(
      barPart({{0, 0, hip - 0.04}, {0, 0, shoulder + 0.03}, 0.15, 0.18, 12}, site.material));
  object.parts.push_back(
      barPart({{0, 0, shoulder}, {0, 0, 0.9 * h}, 0.06, 0.06, 8}, site.material));
  const auto head = static_cast<float>(0.065 * h);
  object.balls.push_back(
      {Eigen::Vector3f(0, 0, static_cast<float>(h) - head), head, Material::cloth});
}
}  // namespace traverse::simulation
