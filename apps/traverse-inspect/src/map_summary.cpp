// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_summary.h"

#include "log_summary.h"

#include <traverse/common_app/map_files.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/output_folder.h>
#include <traverse/formats/safe_file.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
/** Lowest and highest finite value, and how many there are. */
Json rangeOf(const layers::Layer& layer)
{
  return std::visit(
      [&](const auto& values) -> Json
      {
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        uint64_t known = 0;
        for (const auto v : values)
        {
          const auto value = static_cast<double>(v);
          if (std::isfinite(value))
          {
            low = std::min(low, value);
            high = std::max(high, value);
            ++known;
          }
        }
        Json json{{"name", layer.name}, {"unit", layer.unit}, {"known", known}};
        if (known > 0)
        {
          json["min"] = low;
          json["max"] = high;
        }
        return json;
      },
      layer.data);
}

Json mapJson(const std::filesystem::path& file)
{
  const LoadedMap map = loadMap(file);
  Json json{{"file", file.filename().string()}, {"kind", map.kind}, {"bytes", map.bytes}};
  try
  {
    const layers::LayerSet set = map.consumer->layerSet();
    json["cell_m"] = set.lattice.cell_m();
    json["cells"] = {set.extent.width(), set.extent.height()};
    json["min_m"] = {set.lattice.edge_m(set.extent.min.x), set.lattice.edge_m(set.extent.min.y)};
    json["max_m"] = {set.lattice.edge_m(set.extent.max.x), set.lattice.edge_m(set.extent.max.y)};
    for (const auto& [name, count] : layers::cellsByClass(set))
    {
      json["cells_by_class"][name] = count;
    }
    json["layers"] = Json::array();
    for (const layers::Layer& layer : set.layers)
    {
      json["layers"].push_back(rangeOf(layer));
    }
  }
  catch (const std::length_error& e)
  {
    json["note"] = std::string("no layers: ") + e.what();
  }
  return json;
}

/** The run's own account; nothing where the file is missing, foreign or too large. */
Json metricsOf(const std::filesystem::path& folder)
{
  constexpr size_t kLargest = size_t{64} << 20U;
  try
  {
    const Json json =
        parsedMetrics(formats::readFile(folder / formats::OutputFolder::kLastFile, kLargest));
    return json.is_object() ? json : Json();
  }
  catch (const std::exception&)
  {
    return {};
  }
}

std::string scalar(const Json& json)
{
  return json.is_string() ? shown(json.get<std::string>()) : json.dump();
}

std::string runText(const Json& run)
{
  std::string text;
  for (const char* key : {"rawlog", "complete", "scans", "points"})
  {
    if (run.contains(key) && run[key].is_primitive())
    {
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, scalar(run[key]));
    }
  }
  for (const char* key : {"problems", "warnings"})
  {
    if (run.contains(key) && run[key].is_array())
    {
      for (const Json& line : run[key])
      {
        text += fmt::format("\n  {}", line.is_string() ? line.get<std::string>() : line.dump());
      }
    }
  }
  return text.empty() ? "" : "run: " + text + "\n";
}
}  // namespace

Json mapsJson(const std::filesystem::path& folder_or_file)
{
  Json json{{"maps", Json::array()}};
  for (const std::filesystem::path& file : mapFiles(folder_or_file))
  {
    json["maps"].push_back(mapJson(file));
  }
  const Json run = metricsOf(folder_or_file);
  if (!run.is_null())
  {
    json["run"] = run;
  }
  return json;
}

std::string mapsText(const Json& maps)
{
  std::string text = maps.contains("run") ? runText(maps["run"]) : "";
  for (const Json& map : maps["maps"])
  {
    text += fmt::format(
        "{}: {}, {} bytes\n", scalar(map["file"]), scalar(map["kind"]), scalar(map["bytes"]));
    if (map.contains("note"))
    {
      text += "  " + map["note"].get<std::string>() + "\n";
      continue;
    }
    text += fmt::format(
        "  {} x {} cells of {} m, x {} to {} m, y {} to {} m\n", map["cells"][0].dump(),
        map["cells"][1].dump(), map["cell_m"].dump(), map["min_m"][0].dump(),
        map["max_m"][0].dump(), map["min_m"][1].dump(), map["max_m"][1].dump());
    for (const auto& [name, count] : map["cells_by_class"].items())
    {
      text += fmt::format("  {} {}\n", count.dump(), name);
    }
    for (const Json& layer : map["layers"])
    {
      text += fmt::format("  layer {} [{}]", scalar(layer["name"]), scalar(layer["unit"]));
      text += layer.contains("min")
                  ? fmt::format(
                        " {:.4g} to {:.4g} in {} cells\n", layer["min"].get<double>(),
                        layer["max"].get<double>(), layer["known"].dump())
                  : " unknown\n";
    }
  }
  return text;
}
}  // namespace traverse::app
