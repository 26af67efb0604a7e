// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/simulation/labels.h>
#include <traverse/simulation/motion.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace traverse::simulation
{
/** A rectangle of the map frame, m. */
struct Area
{
  double min_x_m = -50;
  double min_y_m = -50;
  double max_x_m = 50;
  double max_y_m = 50;
};

/** The ground at a place. */
struct GroundAt
{
  double height_m = 0;  //!< of the surface: with ruts, banks, ditches
  double base_m = 0;    //!< of the smooth ground that a vehicle comes from: without those
  double ditch_m = 0;   //!< how deep a ditch or hole there lies below base_m; 0: none
  Material material = Material::soil;
  Label label = Label::ground;
};

/** What the ground is made of at a place. */
struct GroundLook
{
  Material material = Material::soil;
  Label label = Label::ground;
};

/** The ground of a scene as functions of place. The same bits on every machine (no libm). */
class Terrain
{
 public:
  virtual ~Terrain() = default;

  virtual GroundAt at(double x_m, double y_m) const = 0;

  /** As at() says; for rays, which know the height. */
  virtual GroundLook look(double x_m, double y_m) const
  {
    const GroundAt ground = at(x_m, y_m);
    return {ground.material, ground.label};
  }

  /** True where something sharp (ruts, kerbs, ditches, steps) lies in the area, so that it needs a
   * fine mesh. */
  virtual bool isSharpIn(const Area& area) const = 0;
};

/** A closed piece of an object, triangles in the object's frame, m. */
struct Part
{
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  Material material = Material::concrete;
  bool solid = true;  //!< what lies between its lowest and highest surface above a place belongs to
                      //!< it; false for loose sheets: leaves, blades
};

/** A ball, in the object's frame, m; exact, not made of triangles. */
struct Ball
{
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float radius_m = 1;
  Material material = Material::concrete;
};

/** A thing on the ground. Its number is its index in the scene + kFirstObject. */
struct Object
{
  std::string name;  //!< of the scene file's section, or what made it
  Label label = Label::thing;
  std::vector<Part> parts;
  std::vector<Ball> balls;
  Motion motion;  //!< of its frame in the map; standing things have one pose
};

/** Throws std::invalid_argument where a triangle has a vertex that is not there. */
void checkTriangles(const Object& object);

/** What there is to be seen. */
struct Scene
{
  Area area;  //!< the ground ends here
  std::shared_ptr<const Terrain> terrain;
  std::vector<Object> objects;

  static constexpr uint32_t kNoObject = 0;  //!< rain, false returns
  static constexpr uint32_t kGround = 1;    //!< the terrain
  static constexpr uint32_t kFirstObject = 2;
};
}  // namespace traverse::simulation
