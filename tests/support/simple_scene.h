// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>

#include <memory>

namespace traverse::testing
{
/** z = height + slope_x x + slope_y y. */
class PlaneTerrain : public simulation::Terrain
{
 public:
  explicit PlaneTerrain(double height_m = 0, double slope_x = 0, double slope_y = 0) :
      height_m_(height_m), slope_x_(slope_x), slope_y_(slope_y)
  {
  }

  simulation::GroundAt at(double x_m, double y_m) const override
  {
    simulation::GroundAt ground;
    ground.height_m = ground.base_m = height_m_ + slope_x_ * x_m + slope_y_ * y_m;
    return ground;
  }

  bool isSharpIn(const simulation::Area& /*area*/) const override { return false; }

 private:
  double height_m_;
  double slope_x_;
  double slope_y_;
};

/** A plane of one material. */
class Floor : public PlaneTerrain
{
 public:
  explicit Floor(simulation::Material material, double slope_x = 0) :
      PlaneTerrain(0, slope_x), material_(material)
  {
  }

  simulation::GroundAt at(double x_m, double y_m) const override
  {
    simulation::GroundAt ground = PlaneTerrain::at(x_m, y_m);
    ground.material = material_;
    return ground;
  }

 private:
  simulation::Material material_;
};

inline simulation::Scene planeScene(double height_m = 0, double slope_x = 0, double slope_y = 0)
{
  simulation::Scene scene;
  scene.area = {-100, -100, 100, 100};
  scene.terrain = std::make_shared<PlaneTerrain>(height_m, slope_x, slope_y);
  return scene;
}

/** A closed box between two corners. */
inline simulation::Part boxPart(const Eigen::Vector3f& min, const Eigen::Vector3f& max)
{
  simulation::Part part;
  for (uint32_t corner = 0; corner < 8; ++corner)
  {
    part.vertices.emplace_back(
        (corner & 1U) != 0 ? max.x() : min.x(), (corner & 2U) != 0 ? max.y() : min.y(),
        (corner & 4U) != 0 ? max.z() : min.z());
  }
  part.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return part;
}

inline simulation::Object boxObject(const Eigen::Vector3f& min, const Eigen::Vector3f& max)
{
  simulation::Object object;
  object.name = "box";
  object.parts.push_back(boxPart(min, max));
  return object;
}
}  // namespace traverse::testing
