// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>

#include <cstdint>
#include <limits>
#include <memory>

namespace traverse::simulation
{
/** A ray of the map frame at a time of the scene. */
struct Ray
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  //!< of length 1
  double t_s = 0;
};

/** What a ray meets first. */
struct Hit
{
  double range_m = std::numeric_limits<double>::infinity();  //!< infinite: nothing
  double cos_incidence = 0;  //!< of the angle to the surface's normal, 0..1
  uint32_t object = Scene::kNoObject;
  Label label = Label::none;
  Material material = Material::soil;

  bool any() const { return object != Scene::kNoObject; }
};

/** More vertices of the ground than these are refused: each takes about 100 bytes. */
inline constexpr uint64_t kMostGroundVertices = 50'000'000;

/** How many vertices the mesh of a scene's ground has, computed without making it; for areas of
 * more tiles than kMostGroundVertices some number above that. */
uint64_t groundVertices(const Scene& scene);

/** Casts rays at a scene with Embree: standing things and the ground in one structure, each moving
 * thing in its own, which a ray meets where that is at the ray's own time. Ranges are exact to
 * 1e-5 of the way to the farthest point of the scene's area from its middle (single precision), and
 * have the same bits on every processor (one instruction set is used). For use by many threads.
 *
 * The ground is a mesh of 5 cm where it is sharp, of 25 cm elsewhere. */
class RayCaster
{
 public:
  /** Copies what it needs. Throws std::invalid_argument for a scene without ground, with more than
   * kMostGroundVertices, or with a triangle of vertices that are not there, std::runtime_error
   * where Embree refuses. */
  explicit RayCaster(const Scene& scene);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /** The first surface within max_m of the ray's origin. */
  Hit cast(const Ray& ray, double max_m) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace traverse::simulation
