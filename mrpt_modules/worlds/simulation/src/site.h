// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/object_params.h>
#include <traverse/simulation/random.h>
#include <traverse/simulation/scene.h>

#include <Eigen/Geometry>

namespace traverse::simulation
{
/** Where an object is built: its parameters with the usual sizes filled in, and the ground in its
 * own frame. */
struct Site
{
  const ObjectParams& params;
  const Terrain& terrain;
  Material material;  //!< of its main part

  /** Of the frame that stands at the place of the parameters. */
  Eigen::Isometry3d frame() const
  {
    const auto [s, c] = geometry::sinCosOf(params.yaw_deg * (geometry::kPi / 180));
    Eigen::Isometry3d T_map_object = Eigen::Isometry3d::Identity();
    T_map_object.linear() << c, -s, 0, s, c, 0, 0, 0, 1;
    T_map_object.translation() << params.x_m, params.y_m,
        terrain.at(params.x_m, params.y_m).height_m + params.z_m;
    return T_map_object;
  }

  /** Height of the ground at a place of its frame, in its frame; z_m above the ground counts in. */
  double groundAt(double x_m, double y_m) const
  {
    const auto [s, c] = geometry::sinCosOf(params.yaw_deg * (geometry::kPi / 180));
    const double here = terrain.at(params.x_m, params.y_m).height_m;
    return terrain.at(params.x_m + c * x_m - s * y_m, params.y_m + s * x_m + c * y_m).height_m -
           here;
  }

  /** Random numbers of a purpose. */
  Random random(uint64_t purpose) const
  {
    return Random(mixed({static_cast<uint64_t>(params.seed), purpose}));
  }
};

// Each adds what its kind consists of, in the object's frame. They throw OptionError.
void addPlainShape(Object& object, const Site& site);  //!< box ... table
void addWall(Object& object, const Site& site);
void addBuilding(Object& object, const Site& site);
void addFence(Object& object, const Site& site);
void addGrass(Object& object, const Site& site);
void addLumps(Object& object, const Site& site);
void addBush(Object& object, const Site& site);
void addTree(Object& object, const Site& site);
void addVehicle(Object& object, const Site& site);
void addPerson(Object& object, const Site& site);

/** Where a vehicle or a person with a track is at which time. */
Motion motionOnTrack(const ObjectParams& params, const Terrain& terrain);

/** Of a vehicle that stands: level across its wheels. */
Motion standingOnWheels(const ObjectParams& params, const Terrain& terrain);
}  // namespace traverse::simulation
