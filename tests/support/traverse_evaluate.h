// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/geotiff.h>
#include <traverse/formats/geotiff_read.h>
#include <traverse/formats/safe_file.h>

#include <string>
#include <support/process.h>
#include <vector>

namespace traverse::testing
{
/** Runs traverse-evaluate as a user would, in a plain environment. */
inline Finished traverseEvaluate(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-evaluate");
  return run(arguments, {"DISPLAY="});
}

/** Truth as traverse-sim writes it, for which a map's own classes are true; each object a thing. */
inline layers::LayerSet truthOfRun(const std::filesystem::path& run)
{
  layers::LayerSet truth = formats::readGeoTiffs({run / "traversability_class.tif"});
  const auto classes = std::get<std::vector<uint8_t>>(truth.layers[0].data);
  truth.class_layer = "truth_class";
  truth.layers[0].name = "truth_class";
  std::vector<uint8_t> states(classes.size(), 0);
  std::vector<uint32_t> objects(classes.size(), 1);
  for (size_t i = 0; i < classes.size(); ++i)
  {
    states[i] = classes[i] == 0 ? uint8_t{0} : classes[i] == 4 ? uint8_t{2} : uint8_t{1};
    objects[i] = classes[i] == 4 ? 2 : 1;
  }
  truth.layers.push_back({"truth_state", "1", std::move(states)});
  truth.layers.push_back({"truth_object", "1", std::move(objects)});
  return truth;
}

inline void writeTruth(const std::filesystem::path& folder, const layers::LayerSet& truth)
{
  std::filesystem::create_directories(folder);
  for (const layers::Layer& layer : truth.layers)
  {
    formats::writeFile(folder / (layer.name + ".tif"), formats::geoTiff(truth, layer));
  }
}
}  // namespace traverse::testing
