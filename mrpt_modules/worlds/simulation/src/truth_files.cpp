// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/geojson.h>
#include <traverse/formats/geotiff.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/recording.h>
#include <traverse/simulation/truth_files.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace traverse::simulation
{
namespace
{
void addLayers(std::vector<TruthFile>& files, const layers::LayerSet& set)
{
  for (const layers::Layer& layer : set.layers)
  {
    const bool named = layer.name.rfind("truth_", 0) == 0;
    files.push_back({(named ? "" : "truth_") + layer.name + ".tif", formats::geoTiff(set, layer)});
  }
}

formats::Feature featureOf(const Footprint& footprint)
{
  return {
      footprint.outlines,
      {{"object", static_cast<double>(footprint.object)},
       {"name", footprint.name},
       {"label", std::string(nameOf(footprint.label))},
       {"height_m", footprint.height_m}}};
}

std::string footprintsJson(const std::vector<Footprint>& all)
{
  std::vector<formats::Feature> features;
  features.reserve(all.size());
  std::transform(all.begin(), all.end(), std::back_inserter(features), featureOf);
  return formats::geoJson(features);
}

/** The scene's things that move, and what their numbers are in the whole scene. */
std::pair<Scene, std::vector<uint32_t>> movingPart(const Scene& scene)
{
  std::pair<Scene, std::vector<uint32_t>> part = {{scene.area, scene.terrain, {}}, {}};
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    if (scene.objects[i].motion.moves())
    {
      part.first.objects.push_back(scene.objects[i]);
      part.second.push_back(Scene::kFirstObject + static_cast<uint32_t>(i));
    }
  }
  return part;
}
}  // namespace

std::vector<TruthFile> truthFiles(const Scene& scene, const TruthRequest& request)
{
  std::vector<TruthFile> files;
  addLayers(files, cellTruth(scene, request.vehicle, request.params, request.to_s, request.start));
  addLayers(files, sweptCells(scene, request.params, request.from_s, request.to_s));
  files.push_back(
      {"footprints.geojson", footprintsJson(footprints(scene, request.vehicle, request.to_s))});
  return files;
}

TruthFile movingThings(const Scene& scene, const geometry::Vehicle& vehicle, double to_s)
{
  const auto [moving, numbers] = movingPart(scene);
  std::vector<formats::Feature> features;
  const auto steps = static_cast<int>(std::floor(to_s / kMovingStepSeconds));
  for (int step = 0; step <= steps && !numbers.empty(); ++step)
  {
    const double t_s = step * kMovingStepSeconds;
    for (Footprint& footprint : footprints(moving, vehicle, t_s))
    {
      footprint.object = numbers.at(footprint.object - Scene::kFirstObject);
      formats::Feature feature = featureOf(footprint);
      feature.properties["time_s"] = poses::secondsBetween(0, kRecordingStart) + t_s;
      features.push_back(std::move(feature));
    }
  }
  return {"moving.geojson", formats::geoJson(features)};
}
}  // namespace traverse::simulation
