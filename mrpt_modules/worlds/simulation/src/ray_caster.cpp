// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "embree_scene.h"
#include "moving_thing.h"

#include <traverse/simulation/ray_caster.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace traverse::simulation
{
namespace
{
constexpr double kTile_m = 8;
constexpr double kFineMesh_m = 0.05;
constexpr double kCoarseMesh_m = 0.25;

Eigen::Vector3d middleOf(const Scene& scene)
{
  const double x = (scene.area.min_x_m + scene.area.max_x_m) / 2;
  const double y = (scene.area.min_y_m + scene.area.max_y_m) / 2;
  return {x, y, scene.terrain->at(x, y).height_m};
}

uint32_t verticesAlong(double length_m, double mesh_m)
{
  return static_cast<uint32_t>(std::max(1.0, std::ceil(length_m / mesh_m - 1e-9))) + 1;
}

/** A piece of the ground and how finely it is meshed. */
struct Tile
{
  Area area;
  uint32_t across = 0;  //!< vertices
  uint32_t along = 0;
};

double tilesAlong(double length_m)
{
  return std::ceil(length_m / kTile_m);
}

/** Calls f(tile) for each; there must be fewer than kMostGroundVertices. */
template <class F>
void forEachTile(const Scene& scene, const F& f)
{
  const Area& all = scene.area;
  const auto across = static_cast<int>(tilesAlong(all.max_x_m - all.min_x_m));
  const auto along = static_cast<int>(tilesAlong(all.max_y_m - all.min_y_m));
  for (int j = 0; j < along; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      const Area tile{
          all.min_x_m + i * kTile_m, all.min_y_m + j * kTile_m,
          std::min(all.max_x_m, all.min_x_m + (i + 1) * kTile_m),
          std::min(all.max_y_m, all.min_y_m + (j + 1) * kTile_m)};
      const double mesh_m = scene.terrain->isSharpIn(tile) ? kFineMesh_m : kCoarseMesh_m;
      f(Tile{
          tile, verticesAlong(tile.max_x_m - tile.min_x_m, mesh_m),
          verticesAlong(tile.max_y_m - tile.min_y_m, mesh_m)});
    }
  }
}

void addGround(const Scene& scene, SurfaceSoup& soup)
{
  const uint64_t vertices = groundVertices(scene);
  if (vertices > kMostGroundVertices)
  {
    throw std::invalid_argument(
        "a ground of " + std::to_string(vertices) + " vertices; at most " +
        std::to_string(kMostGroundVertices) + " are possible");
  }
  forEachTile(
      scene,
      [&](const Tile& tile) { soup.add(*scene.terrain, tile.area, tile.across, tile.along); });
}

SurfaceSoup standing(const Scene& scene)
{
  const Area& area = scene.area;
  if (!scene.terrain || !(area.max_x_m > area.min_x_m) || !(area.max_y_m > area.min_y_m))
  {
    throw std::invalid_argument("a scene needs ground");
  }
  SurfaceSoup soup(middleOf(scene));
  addGround(scene, soup);
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    const Object& object = scene.objects[i];
    if (!object.motion.moves())
    {
      soup.add(object, Scene::kFirstObject + static_cast<uint32_t>(i), object.motion.at(0));
    }
  }
  return soup;
}
}  // namespace

uint64_t groundVertices(const Scene& scene)
{
  const Area& all = scene.area;
  const double tiles =
      tilesAlong(all.max_x_m - all.min_x_m) * tilesAlong(all.max_y_m - all.min_y_m);
  if (!(tiles < static_cast<double>(kMostGroundVertices)))
  {
    return 4 * kMostGroundVertices;  // the corners of as many tiles
  }
  uint64_t vertices = 0;
  forEachTile(
      scene, [&](const Tile& tile) { vertices += uint64_t{tile.across} * uint64_t{tile.along}; });
  return vertices;
}

class RayCaster::Impl
{
 public:
  explicit Impl(const Scene& scene) :
      device_(makeDevice()), terrain_(scene.terrain), standing_(device_.get(), standing(scene))
  {
    for (size_t i = 0; i < scene.objects.size(); ++i)
    {
      const Object& object = scene.objects[i];
      if (object.motion.moves())
      {
        moving_.emplace_back(device_.get(), object, Scene::kFirstObject + static_cast<uint32_t>(i));
      }
    }
  }

  Hit cast(const Ray& ray, double max_m) const
  {
    SoupHit found;
    bool any = standing_.cast(ray.origin, ray.direction, max_m, found);
    for (const MovingThing& thing : moving_)
    {
      const double reach_m = any ? static_cast<double>(found.range_m) : max_m;
      any = thing.cast(ray.origin, ray.direction, ray.t_s, reach_m, found) || any;
    }
    return any ? hitOf(ray, found) : Hit{};
  }

 private:
  Hit hitOf(const Ray& ray, const SoupHit& found) const
  {
    Hit hit;
    hit.range_m = static_cast<double>(found.range_m);
    hit.cos_incidence = static_cast<double>(found.cos_incidence);
    hit.object = found.is_ground ? Scene::kGround : found.surface.object;
    hit.label = found.surface.label;
    hit.material = found.surface.material;
    if (found.is_ground)
    {
      const Eigen::Vector3d p = ray.origin + hit.range_m * ray.direction;
      const GroundLook ground = terrain_->look(p.x(), p.y());
      hit.label = ground.label;
      hit.material = ground.material;
    }
    return hit;
  }

  Device device_;
  std::shared_ptr<const Terrain> terrain_;
  EmbreeScene standing_;
  std::vector<MovingThing> moving_;
};

RayCaster::RayCaster(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

Hit RayCaster::cast(const Ray& ray, double max_m) const
{
  return impl_->cast(ray, max_m);
}
}  // namespace traverse::simulation
