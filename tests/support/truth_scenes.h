// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>

#include <functional>
#include <memory>
#include <utility>

// Small scenes of a formula and a few boxes.
namespace traverse::testing
{
/** Terrain of a function of place, sharp everywhere. */
class FormulaTerrain : public simulation::Terrain
{
 public:
  using Formula = std::function<simulation::GroundAt(double, double)>;

  explicit FormulaTerrain(Formula formula, bool sharp = true) :
      formula_(std::move(formula)), sharp_(sharp)
  {
  }

  simulation::GroundAt at(double x_m, double y_m) const override { return formula_(x_m, y_m); }

  bool isSharpIn(const simulation::Area& /*area*/) const override { return sharp_; }

 private:
  Formula formula_;
  bool sharp_;
};

/** Smooth ground of this height. */
inline simulation::GroundAt ground(double height_m)
{
  simulation::GroundAt at;
  at.height_m = height_m;
  at.base_m = height_m;
  return at;
}

/** Ground of this height over (or under) smooth ground at 0. */
inline simulation::GroundAt relief(double height_m)
{
  simulation::GroundAt at;
  at.height_m = height_m;
  return at;
}

/** Terrain of a formula, 8 x 8 m around zero. */
inline simulation::Scene sceneOf(FormulaTerrain::Formula formula, bool sharp = true)
{
  simulation::Scene scene;
  scene.area = {-4, -4, 4, 4};
  scene.terrain = std::make_shared<FormulaTerrain>(std::move(formula), sharp);
  return scene;
}

inline simulation::Scene levelScene()
{
  return sceneOf([](double, double) { return ground(0); });
}

struct Corners
{
  Eigen::Vector3f min;
  Eigen::Vector3f max;
};

inline simulation::Part boxPart(
    const Corners& c, simulation::Material material = simulation::Material::concrete)
{
  simulation::Part part;
  part.material = material;
  for (unsigned i = 0; i < 8; ++i)
  {
    part.vertices.emplace_back(
        (i & 1U) == 0 ? c.min.x() : c.max.x(), (i & 2U) == 0 ? c.min.y() : c.max.y(),
        (i & 4U) == 0 ? c.min.z() : c.max.z());
  }
  part.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return part;
}

inline simulation::Object boxObject(
    const Corners& corners, simulation::Label label = simulation::Label::thing)
{
  simulation::Object object;
  object.name = "box";
  object.label = label;
  object.parts.push_back(boxPart(corners));
  return object;
}

/** Blades of grass of this height: upright triangles that fill [min, max] of the plane. */
inline simulation::Object grassObject(const Corners& field, float height_m)
{
  simulation::Object object;
  object.name = "grass";
  object.label = simulation::Label::grass;
  simulation::Part part;
  part.material = simulation::Material::grass;
  part.solid = false;
  constexpr float kApart_m = 0.04F;
  const int columns = static_cast<int>((field.max.x() - field.min.x()) / kApart_m);
  const int rows = static_cast<int>((field.max.y() - field.min.y()) / kApart_m);
  for (int k = 0; k < columns * rows; ++k)
  {
    const float x = field.min.x() + kApart_m * (static_cast<float>(k % columns) + 0.5F);
    const float y = field.min.y() + kApart_m * (static_cast<float>(k / columns) + 0.5F);
    const auto first = static_cast<uint32_t>(part.vertices.size());
    part.vertices.emplace_back(x - 0.002F, y, 0.0F);
    part.vertices.emplace_back(x + 0.002F, y, 0.0F);
    part.vertices.emplace_back(x, y, height_m);
    part.triangles.push_back({first, first + 1, first + 2});
  }
  object.parts.push_back(std::move(part));
  return object;
}
}  // namespace traverse::testing
