// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <embree3/rtcore.h>
#include <memory>
#include <vector>

// Embree 3 with our types. One instruction set, one thread for building: the same bits everywhere.
namespace traverse::simulation
{
struct ReleaseDevice
{
  void operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
};

struct ReleaseScene
{
  void operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }
};

using Device = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;

/** Throws std::runtime_error. */
Device makeDevice();

/** Which surface primitives from `first` on belong to. */
struct SurfaceRun
{
  uint32_t first = 0;
  uint32_t object = 0;
  Label label = Label::none;
  Material material = Material::soil;
};

/** Triangles, balls and height grids, collected and then given to Embree. Coordinates are relative
 * to `origin`, in single precision. */
class SurfaceSoup
{
 public:
  explicit SurfaceSoup(Eigen::Vector3d origin) : origin_(std::move(origin)) {}

  /** Adds a thing at a pose. Throws std::invalid_argument for triangles of vertices that are not
   * there. */
  void add(const Object& object, uint32_t number, const Eigen::Isometry3d& T_map_body);

  /** Adds the ground of an area as columns x rows vertices, evenly spread from border to border. */
  void add(const Terrain& terrain, const Area& area, uint32_t columns, uint32_t rows);

 private:
  friend class EmbreeScene;

  struct Grid
  {
    uint32_t first_vertex = 0;
    uint32_t columns = 0;
    uint32_t rows = 0;
  };

  using Vertex = std::array<float, 3>;

  Vertex vertexAt(const Eigen::Vector3d& p_map) const;

  Eigen::Vector3d origin_;
  std::vector<Vertex> vertices_;
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<SurfaceRun> triangle_runs_;
  std::vector<std::array<float, 4>> balls_;
  std::vector<SurfaceRun> ball_runs_;
  std::vector<Vertex> grid_vertices_;
  std::vector<Grid> grids_;
};

/** What a ray meets in a soup. */
struct SoupHit
{
  float range_m = 0;
  float cos_incidence = 0;
  bool is_ground = false;
  SurfaceRun surface;  //!< where it is not the ground
};

/** A soup that rays can be cast at. */
class EmbreeScene
{
 public:
  /** Throws std::runtime_error where Embree has no memory. */
  EmbreeScene(RTCDeviceTy* device, SurfaceSoup soup);

  /** Nothing within (0, max_m]: false. The direction is of length 1. */
  bool cast(
      const Eigen::Vector3d& origin,
      const Eigen::Vector3d& direction,
      double max_m,
      SoupHit& hit) const;

 private:
  enum Geometry : uint32_t
  {
    kTriangles,
    kBalls,
    kGrids,
  };

  void attach(RTCDeviceTy* device, RTCGeometryTy* geometry, Geometry id);
  void addTriangles(RTCDeviceTy* device, const SurfaceSoup& soup);
  void addBalls(RTCDeviceTy* device, const SurfaceSoup& soup);
  void addGrids(RTCDeviceTy* device, const SurfaceSoup& soup);

  Eigen::Vector3d origin_;
  std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
  std::vector<SurfaceRun> triangle_runs_;
  std::vector<SurfaceRun> ball_runs_;
};
}  // namespace traverse::simulation
