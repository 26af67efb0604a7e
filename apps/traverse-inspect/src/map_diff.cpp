// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map_diff.h"

#include <traverse/common_app/map_files.h>
#include <traverse/formats/bytes.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace traverse::app
{
namespace
{
using geometry::CellIndex;
using geometry::CellRect;
using layers::Layer;
using layers::LayerSet;

/** A layer's values by cell of the lattice; NaN where unknown, and code 0 of the class layer. */
class Values
{
 public:
  Values(const LayerSet& set, const Layer& layer) :
      extent_(set.extent), data_(layer.data), classes_(layer.name == set.class_layer)
  {
  }

  double at(CellIndex c) const
  {
    if (!extent_.contains(c))
    {
      return std::nan("");
    }
    const auto width = static_cast<size_t>(extent_.width());
    const auto i =
        static_cast<size_t>(c.y - extent_.min.y) * width + static_cast<size_t>(c.x - extent_.min.x);
    const double value =
        std::visit([&](const auto& values) { return static_cast<double>(values[i]); }, data_);
    return classes_ && value == 0 ? std::nan("") : value;
  }

 private:
  CellRect extent_;
  const decltype(Layer::data)& data_;
  bool classes_;
};

/** How two layers of one name differ. */
struct LayerDiff
{
  uint64_t known = 0;   //!< cells known in either
  uint64_t only_a = 0;  //!< known there only
  uint64_t only_b = 0;
  uint64_t changed = 0;  //!< known in both, further apart than the tolerance
  double largest = 0;    //!< difference
  double squares = 0;    //!< sum over the cells known in both

  uint64_t differing() const { return only_a + only_b + changed; }
};

void compare(double a, double b, double tolerance, LayerDiff& diff)
{
  const bool in_a = !std::isnan(a);
  const bool in_b = !std::isnan(b);
  diff.known += in_a || in_b ? 1 : 0;
  diff.only_a += in_a && !in_b ? 1 : 0;
  diff.only_b += in_b && !in_a ? 1 : 0;
  if (in_a && in_b && a != b)
  {
    const double apart = std::abs(a - b);
    diff.changed += apart > tolerance ? 1 : 0;
    diff.largest = std::max(diff.largest, apart);
    diff.squares += apart * apart;
  }
}

template <class Visit>
void forEachCell(const CellRect& extent, const Visit& visit)
{
  for (int32_t y = extent.min.y; y < extent.max.y; ++y)
  {
    for (int32_t x = extent.min.x; x < extent.max.x; ++x)
    {
      visit(CellIndex{x, y});
    }
  }
}

/** All cells of one extent, then those of the other that were not among them. */
LayerDiff compare(const LayerSet& a, const LayerSet& b, const std::string& name, double tolerance)
{
  const Layer nothing{name, "", std::vector<float>()};
  const Layer* in_a = a.find(name);
  const Layer* in_b = b.find(name);
  const LayerSet empty;
  const Values values_a(in_a != nullptr ? a : empty, in_a != nullptr ? *in_a : nothing);
  const Values values_b(in_b != nullptr ? b : empty, in_b != nullptr ? *in_b : nothing);
  const double may_differ = name == a.class_layer || name == b.class_layer ? 0 : tolerance;
  LayerDiff diff;
  forEachCell(
      a.extent, [&](CellIndex c) { compare(values_a.at(c), values_b.at(c), may_differ, diff); });
  forEachCell(
      b.extent,
      [&](CellIndex c)
      {
        if (!a.extent.contains(c))
        {
          compare(values_a.at(c), values_b.at(c), may_differ, diff);
        }
      });
  return diff;
}

Json toJson(const std::string& name, const LayerDiff& diff, double cells_tolerance)
{
  const auto known = static_cast<double>(std::max<uint64_t>(1, diff.known));
  const auto both =
      static_cast<double>(std::max<uint64_t>(1, diff.known - diff.only_a - diff.only_b));
  const double share = static_cast<double>(diff.differing()) / known;
  return {
      {"layer", name},
      {"same", share <= cells_tolerance},
      {"cells", diff.known},
      {"only_in_a", diff.only_a},
      {"only_in_b", diff.only_b},
      {"changed", diff.changed},
      {"largest_difference", diff.largest},
      {"rms_difference", std::sqrt(diff.squares / both)}};
}

LayerSet layersOf(const std::filesystem::path& file, std::string& kind)
{
  const LoadedMap map = loadMap(file);
  kind = map.kind;
  try
  {
    return map.consumer->layerSet();
  }
  catch (const std::length_error& e)
  {
    throw formats::FormatError(fmt::format("'{}': {}", file.string(), e.what()));
  }
}

Json diffOf(
    const std::filesystem::path& a, const std::filesystem::path& b, const DiffTolerance& tolerance)
{
  std::string kind_a;
  std::string kind_b;
  const LayerSet set_a = layersOf(a, kind_a);
  const LayerSet set_b = layersOf(b, kind_b);
  Json json{{"a", a.string()}, {"b", b.string()}, {"same", true}, {"layers", Json::array()}};
  if (kind_a != kind_b || !(set_a.lattice == set_b.lattice))
  {
    json["same"] = false;
    json["note"] = fmt::format(
        "not to be compared: {} of {} m cells, {} of {} m cells", kind_a, set_a.lattice.cell_m(),
        kind_b, set_b.lattice.cell_m());
    return json;
  }
  std::set<std::string> names;
  for (const LayerSet* set : {&set_a, &set_b})
  {
    for (const Layer& layer : set->layers)
    {
      names.insert(layer.name);
    }
  }
  for (const std::string& name : names)
  {
    const Json layer = toJson(name, compare(set_a, set_b, name, tolerance.value), tolerance.cells);
    json["same"] = json["same"].get<bool>() && layer["same"].get<bool>();
    json["layers"].push_back(layer);
  }
  return json;
}
}  // namespace

Json diffJson(
    const std::filesystem::path& a, const std::filesystem::path& b, const DiffTolerance& tolerance)
{
  for (const std::filesystem::path& input : {a, b})
  {
    if (std::filesystem::is_regular_file(input) && input.extension() != ".traverse")
    {
      throw formats::FormatError("'" + input.string() + "' is no map (*.traverse)");
    }
  }
  const std::vector<std::filesystem::path> files_a = mapFiles(a);
  const std::vector<std::filesystem::path> files_b = mapFiles(b);
  if (files_a.size() != files_b.size())
  {
    throw formats::FormatError(fmt::format(
        "'{}' has {} maps, '{}' has {}", a.string(), files_a.size(), b.string(), files_b.size()));
  }
  Json json{{"same", true}, {"maps", Json::array()}};
  for (size_t i = 0; i < files_a.size(); ++i)
  {
    const Json map = diffOf(files_a[i], files_b[i], tolerance);
    json["same"] = json["same"].get<bool>() && map["same"].get<bool>();
    json["maps"].push_back(map);
  }
  return json;
}

std::string diffText(const Json& diff)
{
  std::string text;
  for (const Json& map : diff["maps"])
  {
    text += fmt::format("{} and {}\n", map["a"].get<std::string>(), map["b"].get<std::string>());
    text += map.contains("note") ? "  " + map["note"].get<std::string>() + "\n" : "";
    for (const Json& layer : map["layers"])
    {
      text += fmt::format(
          "  {} {}: {} cells, {} only in the first, {} only in the second, {} changed, largest "
          "difference {:.6g}, rms {:.6g}\n",
          layer["same"].get<bool>() ? "same   " : "differs", layer["layer"].get<std::string>(),
          layer["cells"].dump(), layer["only_in_a"].dump(), layer["only_in_b"].dump(),
          layer["changed"].dump(), layer["largest_difference"].get<double>(),
          layer["rms_difference"].get<double>());
    }
  }
  return text + (diff["same"].get<bool>() ? "same\n" : "different\n");
}
}  // namespace traverse::app
