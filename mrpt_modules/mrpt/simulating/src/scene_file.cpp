// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ini_sections.h"

#include <traverse/config/strict.h>
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/ray_caster.h>

#include <fmt/format.h>

namespace traverse::simulating
{
namespace
{
using config::ConfigError;
using simulation::numberedSection;
using simulation::SceneParams;

/** [Drive] belongs to the sensors; here only the way that a random scene proposes. */
const options::Option kDriveXs{"xs_m", "corners of the vehicle's way: x, m", {-1e5, 1e5}};
const options::Option kDriveYs{"ys_m", "the same corners' y, m", {-1e5, 1e5}};

template <class P>
std::vector<P> readNumbered(const config::IniDocument& ini, const std::string& prefix)
{
  std::vector<P> all(countNumbered(ini, prefix));
  for (size_t i = 0; i < all.size(); ++i)
  {
    config::load(ini, numberedSection(prefix, i), all[i]);
  }
  return all;
}

/** Sections that are nearly ours would silently do nothing. */
void refuseLookalikes(const config::IniDocument& ini)
{
  for (const std::string& section : ini.sections())
  {
    for (const std::string_view name : {"Scene", "Random", "Mission"})
    {
      if (beginsWith(section, name) && !config::sameName(section, name))
      {
        throw ConfigError(
            placeOf(ini, section) + "section [" + section + "]: did you mean [" +
                std::string(name) + "]?",
            section);
      }
    }
    for (const std::string_view name : {"Terrain", "Object"})
    {
      if (beginsWith(section, name) && !beginsWith(section, std::string(name) + "_"))
      {
        throw ConfigError(
            placeOf(ini, section) + "section [" + section + "]: allowed: " + std::string(name) +
                "_00, " + std::string(name) + "_01 ...",
            section);
      }
    }
  }
}

void readCorners(
    const config::IniDocument& ini, const options::Option& option, std::vector<double>& corners)
{
  const config::Entry* entry = ini.find("Drive", option.key);
  if (entry == nullptr)
  {
    return;
  }
  try
  {
    options::parse(option, entry->value, corners);
  }
  catch (const options::OptionError& e)
  {
    throw ConfigError(entry->place + ": [Drive] " + e.what(), "Drive", std::string(option.key));
  }
}

/** The keys of p that are not as in P{}; for numbered sections `kind` always. */
template <class P>
std::string keysText(const std::string& section, const P& p)
{
  const std::vector<options::Row> usual = options::rows(P{});
  const std::vector<options::Row> rows = options::rows(p);
  std::string text;
  for (size_t i = 0; i < rows.size(); ++i)
  {
    if (rows[i].value != usual[i].value || rows[i].key == "kind")
    {
      text += keyLine(section, rows[i].key, rows[i].value);
    }
  }
  return text;
}

template <class P>
std::string sectionText(const std::string& section, const P& p)
{
  const std::string keys = keysText(section, p);
  return keys.empty() ? "" : "[" + section + "]\n" + keys + "\n";
}
}  // namespace

SceneParams readScene(const config::IniDocument& ini)
{
  refuseLookalikes(ini);
  SceneParams scene;
  scene.folder = ini.folder();
  config::load(ini, "Scene", scene.extent);
  config::load(ini, "Random", scene.random);
  config::load(ini, "Mission", scene.mission);
  scene.terrains = readNumbered<simulation::TerrainParams>(ini, "Terrain_");
  scene.objects = readNumbered<simulation::ObjectParams>(ini, "Object_");
  readCorners(ini, kDriveXs, scene.drive_xs_m);
  readCorners(ini, kDriveYs, scene.drive_ys_m);
  return scene;
}

std::string sceneText(const SceneParams& scene)
{
  std::string text = sectionText("Scene", scene.extent) + sectionText("Random", scene.random);
  for (size_t i = 0; i < scene.terrains.size(); ++i)
  {
    text += sectionText(numberedSection("Terrain_", i), scene.terrains[i]);
  }
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    text += sectionText(numberedSection("Object_", i), scene.objects[i]);
  }
  text += sectionText("Mission", scene.mission);
  if (!scene.drive_xs_m.empty())
  {
    text += "[Drive]\n" + keyLine("Drive", "xs_m", options::format(scene.drive_xs_m)) +
            keyLine("Drive", "ys_m", options::format(scene.drive_ys_m));
  }
  return text;
}

void checkGround(const simulation::Scene& scene)
{
  const uint64_t vertices = simulation::groundVertices(scene);
  if (vertices > simulation::kMostGroundVertices)
  {
    throw config::ConfigError(
        fmt::format(
            "[Scene]: the ground has {} vertices (every 5 cm where it is sharp, every 25 cm "
            "elsewhere); allowed: {}, so a smaller area",
            vertices, simulation::kMostGroundVertices),
        "Scene");
  }
}
}  // namespace traverse::simulating
