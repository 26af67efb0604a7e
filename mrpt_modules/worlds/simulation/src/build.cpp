// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "object_usual.h"
#include "refuse.h"
#include "site.h"

#include <traverse/simulation/build.h>

namespace traverse::simulation
{
namespace
{
/** The parameters with the usual values where they have none. */
ObjectParams withUsual(ObjectParams p, const UsualObject& usual)
{
  const auto fill = [](auto& value, auto otherwise) { value = value > 0 ? value : otherwise; };
  fill(p.length_m, usual.length_m);
  fill(p.width_m, usual.width_m);
  fill(p.height_m, usual.height_m);
  fill(p.radius_m, usual.radius_m);
  fill(p.branch_height_m, usual.branch_height_m);
  fill(p.count, usual.count);
  return p;
}

void addParts(Object& object, const Site& site)
{
  switch (site.params.kind)
  {
    case ObjectKind::wall:
      return addWall(object, site);
    case ObjectKind::building:
      return addBuilding(object, site);
    case ObjectKind::fence_wire:
    case ObjectKind::fence_board:
      return addFence(object, site);
    case ObjectKind::grass:
      return addGrass(object, site);
    case ObjectKind::lumps:
      return addLumps(object, site);
    case ObjectKind::bush:
      return addBush(object, site);
    case ObjectKind::tree:
      return addTree(object, site);
    case ObjectKind::vehicle:
      return addVehicle(object, site);
    case ObjectKind::person:
      return addPerson(object, site);
    default:
      return addPlainShape(object, site);
  }
}

Motion motionOf(const Site& site)
{
  const ObjectParams& p = site.params;
  const bool mover = p.kind == ObjectKind::vehicle || p.kind == ObjectKind::person;
  if (!p.track_xs_m.empty() || !p.track_ys_m.empty())
  {
    if (!mover)
    {
      throw options::OptionError(
          "track_xs_m", options::format(p.track_xs_m), "only for kind = vehicle and person");
    }
    return motionOnTrack(p, site.terrain);
  }
  return p.kind == ObjectKind::vehicle ? standingOnWheels(p, site.terrain)
                                       : Motion({{0, site.frame()}});
}

Object buildObject(const ObjectParams& given, const Terrain& terrain, const std::string& name)
{
  options::check(given);
  const UsualObject& usual = kUsualObjects.at(static_cast<size_t>(given.kind));
  const ObjectParams params = withUsual(given, usual);
  const Site site{params, terrain, chosenOr(params.material, usual.material)};
  Object object;
  object.name = name;
  object.label = chosenOr(params.label, usual.label);
  object.motion = motionOf(site);
  addParts(object, site);
  return object;
}
}  // namespace

Scene buildScene(const SceneParams& params)
{
  Scene scene;
  const SceneExtentParams& e = params.extent;
  scene.area = {e.min_x_m, e.min_y_m, e.max_x_m, e.max_y_m};
  scene.terrain = buildTerrain(params);
  scene.objects.reserve(params.objects.size());
  for (size_t i = 0; i < params.objects.size(); ++i)
  {
    const std::string section = numberedSection("Object_", i);
    scene.objects.push_back(inSection(
        section, [&] { return buildObject(params.objects[i], *scene.terrain, section); }));
  }
  return scene;
}
}  // namespace traverse::simulation
