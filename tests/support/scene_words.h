// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/build.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>

// Scenes made of a few words.
namespace traverse::testing
{
inline simulation::TerrainParams terrainOf(simulation::TerrainKind kind)
{
  simulation::TerrainParams p;
  p.kind = kind;
  return p;
}

inline simulation::ObjectParams objectOf(simulation::ObjectKind kind)
{
  simulation::ObjectParams p;
  p.kind = kind;
  return p;
}

/** A scene of 40 x 40 m with these pieces of ground. */
inline simulation::SceneParams sceneWith(std::vector<simulation::TerrainParams> terrains)
{
  simulation::SceneParams scene;
  scene.extent.min_x_m = scene.extent.min_y_m = -20;
  scene.extent.max_x_m = scene.extent.max_y_m = 20;
  scene.terrains = std::move(terrains);
  return scene;
}

/** The paper's world on 60 x 60 m. */
inline simulation::SceneParams randomScene(uint64_t seed)
{
  simulation::SceneParams scene;
  scene.extent.min_x_m = scene.extent.min_y_m = -30;
  scene.extent.max_x_m = scene.extent.max_y_m = 30;
  scene.random.style = simulation::RandomStyle::paper_3;
  return simulation::generate(scene, seed);
}

/** True where each edge belongs to two triangles, which pass it in opposite directions. */
inline bool isClosed(const simulation::Part& part)
{
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto& t : part.triangles)
  {
    for (size_t i = 0; i < 3; ++i)
    {
      ++edges[{t.at(i), t.at((i + 1) % 3)}];
    }
  }
  for (const auto& [edge, times] : edges)
  {
    const auto back = edges.find({edge.second, edge.first});
    if (times != 1 || back == edges.end() || back->second != 1)
    {
      return false;
    }
  }
  return !edges.empty();
}

/** The volume that a closed part encloses, m3; negative where it is inside out. */
inline double volumeOf(const simulation::Part& part)
{
  double sum = 0;
  for (const auto& [a, b, c] : part.triangles)
  {
    const Eigen::Vector3d p = part.vertices.at(a).cast<double>();
    sum += p.dot(part.vertices.at(b).cast<double>().cross(part.vertices.at(c).cast<double>()));
  }
  return sum / 6;
}

/** All bytes of all vertices of a scene. */
inline std::string vertexBytes(const simulation::Scene& scene)
{
  std::string bytes;
  for (const simulation::Object& object : scene.objects)
  {
    for (const simulation::Part& part : object.parts)
    {
      bytes.append(
          reinterpret_cast<const char*>(part.vertices.data()),
          part.vertices.size() * sizeof(Eigen::Vector3f));
    }
  }
  return bytes;
}
}  // namespace traverse::testing
