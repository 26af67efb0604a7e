// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/geojson.h>
#include <traverse/formats/geotiff.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/truth_files.h>

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

std::string footprintsJson(const std::vector<Footprint>& all)
{
  std::vector<formats::Feature> features;
  features.reserve(all.size());
  for (const Footprint& footprint : all)
  {
    features.push_back(
        {footprint.outlines,
         {{"object", static_cast<double>(footprint.object)},
          {"name", footprint.name},
          {"label", std::string(nameOf(footprint.label))},
          {"height_m", footprint.height_m}}});
  }
  return formats::geoJson(features);
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
}  // namespace traverse::simulation
