// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/geojson.h>
#include <traverse/formats/geotiff.h>
#include <traverse/formats/trajectory.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/truth_files.h>

#include <fmt/format.h>

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

/** A text as a field of a CSV file. */
std::string quoted(const std::string& text)
{
  std::string field = "\"";
  for (const char c : text)
  {
    field += c == '"' ? "\"\"" : std::string(1, c);
  }
  return field + "\"";
}

std::string objectsCsv(const Scene& scene, double at_s)
{
  std::string csv = "object,name,label,moves,x_m,y_m,z_m\n";
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    const Object& object = scene.objects[i];
    const Eigen::Vector3d p = object.motion.at(at_s).translation();
    csv += fmt::format(
        "{},{},{},{},{:.6f},{:.6f},{:.6f}\n", Scene::kFirstObject + i, quoted(object.name),
        nameOf(object.label), object.motion.moves() ? 1 : 0, p.x(), p.y(), p.z());
  }
  return csv;
}
}  // namespace

std::vector<TruthFile> truthFiles(const Scene& scene, const TruthRequest& request)
{
  std::vector<TruthFile> files;
  addLayers(files, cellTruth(scene, request.vehicle, request.params, request.to_s, request.start));
  addLayers(files, sweptCells(scene, request.params, request.from_s, request.to_s));
  files.push_back(
      {"footprints.geojson", footprintsJson(footprints(scene, request.vehicle, request.to_s))});
  files.push_back({"objects.csv", objectsCsv(scene, request.to_s)});
  files.push_back({"trajectory.tum", formats::tumTrajectory(request.trajectory)});
  return files;
}
}  // namespace traverse::simulation
