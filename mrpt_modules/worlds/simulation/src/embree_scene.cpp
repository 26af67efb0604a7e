// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "embree_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
void requireNoError(RTCDeviceTy* device)
{
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
  {
    throw std::runtime_error("Embree refuses the scene, error " + std::to_string(error));
  }
}

/** Embree's own copy of an array; it may read 16 bytes behind each element. */
template <class T>
void fill(
    RTCGeometryTy* geometry, RTCBufferType type, RTCFormat format, const std::vector<T>& elements)
{
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), elements.size());
  if (buffer != nullptr)
  {
    std::memcpy(buffer, elements.data(), elements.size() * sizeof(T));
  }
}

const SurfaceRun& runOf(const std::vector<SurfaceRun>& runs, uint32_t primitive)
{
  const auto later = std::upper_bound(
      runs.begin(), runs.end(), primitive,
      [](uint32_t p, const SurfaceRun& run) { return p < run.first; });
  return *(later - 1);
}
}  // namespace

Device makeDevice()
{
  Device device(rtcNewDevice("threads=1,isa=sse4.2"));
  if (!device)
  {
    throw std::runtime_error("Embree does not start");
  }
  return device;
}

EmbreeScene::EmbreeScene(RTCDeviceTy* device, SurfaceSoup soup) :
    origin_(soup.origin_),
    scene_(rtcNewScene(device)),
    triangle_runs_(std::move(soup.triangle_runs_)),
    ball_runs_(std::move(soup.ball_runs_))
{
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
  addTriangles(device, soup);
  addBalls(device, soup);
  addGrids(device, soup);
  rtcCommitScene(scene_.get());
  requireNoError(device);
}

void EmbreeScene::attach(RTCDeviceTy* device, RTCGeometryTy* geometry, Geometry id)
{
  requireNoError(device);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_.get(), geometry, id);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::addTriangles(RTCDeviceTy* device, const SurfaceSoup& soup)
{
  if (soup.triangles_.empty())
  {
    return;
  }
  RTCGeometryTy* geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, soup.vertices_);
  fill(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, soup.triangles_);
  attach(device, geometry, kTriangles);
}

void EmbreeScene::addBalls(RTCDeviceTy* device, const SurfaceSoup& soup)
{
  if (soup.balls_.empty())
  {
    return;
  }
  RTCGeometryTy* geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, soup.balls_);
  attach(device, geometry, kBalls);
}

void EmbreeScene::addGrids(RTCDeviceTy* device, const SurfaceSoup& soup)
{
  if (soup.grids_.empty())
  {
    return;
  }
  std::vector<RTCGrid> grids;
  grids.reserve(soup.grids_.size());
  for (const SurfaceSoup::Grid& grid : soup.grids_)
  {
    grids.push_back(
        {grid.first_vertex, grid.columns, static_cast<uint16_t>(grid.columns),
         static_cast<uint16_t>(grid.rows)});
  }
  RTCGeometryTy* geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_GRID);
  fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, soup.grid_vertices_);
  fill(geometry, RTC_BUFFER_TYPE_GRID, RTC_FORMAT_GRID, grids);
  attach(device, geometry, kGrids);
}

bool EmbreeScene::cast(
    const Eigen::Vector3d& origin,
    const Eigen::Vector3d& direction,
    double max_m,
    SoupHit& hit) const
{
  const Eigen::Vector3f o = (origin - origin_).cast<float>();
  const Eigen::Vector3f d = direction.cast<float>();
  RTCRayHit ray{};
  ray.ray.org_x = o.x();
  ray.ray.org_y = o.y();
  ray.ray.org_z = o.z();
  ray.ray.dir_x = d.x();
  ray.ray.dir_y = d.y();
  ray.ray.dir_z = d.z();
  ray.ray.tfar = static_cast<float>(max_m);
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_.get(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
  {
    return false;
  }
  const Eigen::Vector3f normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
  hit.range_m = ray.ray.tfar;
  hit.cos_incidence = std::abs(normal.dot(d)) / std::max(normal.norm(), 1e-30F);
  hit.is_ground = ray.hit.geomID == kGrids;
  if (!hit.is_ground)
  {
    hit.surface = runOf(ray.hit.geomID == kTriangles ? triangle_runs_ : ball_runs_, ray.hit.primID);
  }
  return true;
}
}  // namespace traverse::simulation
