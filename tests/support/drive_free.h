// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>
#include <traverse/simulation/scene_params.h>

#include <algorithm>
#include <vector>

// How near things come to a vehicle's way.
namespace traverse::testing
{
/** Distance of a place from the way that the vehicle drives, m. */
inline double fromDrive(const simulation::SceneParams& scene, const Eigen::Vector2d& place)
{
  double nearest = 1e9;
  for (size_t i = 0; i + 1 < scene.drive_xs_m.size(); ++i)
  {
    const Eigen::Vector2d a(scene.drive_xs_m[i], scene.drive_ys_m[i]);
    const Eigen::Vector2d b(scene.drive_xs_m[i + 1], scene.drive_ys_m[i + 1]);
    const double along = std::clamp((place - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (place - a - along * (b - a)).norm());
  }
  return nearest;
}

/** The nearest that a part comes to the way below the vehicle's height. */
inline double nearestLow(
    const simulation::SceneParams& words,
    const simulation::Terrain& terrain,
    const simulation::Part& part,
    const simulation::TimedPose& pose)
{
  constexpr double kVehicle_m = 2.2;
  double nearest = 1e9;
  for (const Eigen::Vector3f& v : part.vertices)
  {
    const Eigen::Vector3d p = pose.T_map_body * v.cast<double>();
    if (p.z() - terrain.at(p.x(), p.y()).base_m < kVehicle_m)
    {
      nearest = std::min(nearest, fromDrive(words, p.head<2>()));
    }
  }
  return nearest;
}

/** The nearest that any of an object does, every 0.4 s. */
inline double nearestLow(
    const simulation::SceneParams& words,
    const simulation::Scene& scene,
    const simulation::Object& object)
{
  const std::vector<simulation::TimedPose>& poses = object.motion.poses();
  double nearest = 1e9;
  for (size_t i = 0; i < poses.size(); i += 4)
  {
    for (const simulation::Part& part : object.parts)
    {
      nearest = std::min(nearest, nearestLow(words, *scene.terrain, part, poses[i]));
    }
  }
  return nearest;
}
}  // namespace traverse::testing
