// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/geojson.h>
#include <traverse/geometry/lattice.h>

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
using Json = nlohmann::ordered_json;

Json coordinate(const Eigen::Vector2d& p)
{
  constexpr double kPerMetre = 1e6;
  // + 0.0: no negative zeros
  return {
      std::round(p.x() * kPerMetre) / kPerMetre + 0.0,
      std::round(p.y() * kPerMetre) / kPerMetre + 0.0};
}

Json polygon(const Ring& ring)
{
  if (ring.size() < 3)
  {
    throw std::invalid_argument("a polygon has three corners at least");
  }
  Json corners = Json::array();
  for (const Eigen::Vector2d& p : ring)
  {
    corners.push_back(coordinate(p));
  }
  corners.push_back(coordinate(ring.front()));
  Json rings = Json::array();
  rings.push_back(std::move(corners));
  return rings;
}

Json featureJson(const Feature& feature)
{
  Json polygons = Json::array();
  for (const Ring& ring : feature.polygons)
  {
    polygons.push_back(polygon(ring));
  }
  Json properties = Json::object();
  for (const auto& [key, value] : feature.properties)
  {
    std::visit([&, &name = key](const auto& v) { properties[name] = v; }, value);
  }
  return {
      {"type", "Feature"},
      {"properties", std::move(properties)},
      {"geometry", {{"type", "MultiPolygon"}, {"coordinates", std::move(polygons)}}}};
}

Eigen::Vector2d parsedCorner(const Json& json)
{
  const auto good = [](const Json& v)
  { return v.is_number() && std::abs(v.get<double>()) <= geometry::kFarthest_m; };
  if (!json.is_array() || json.size() < 2 || !good(json[0]) || !good(json[1]))
  {
    throw FormatError("a corner is not two finite numbers within 1e8 m");
  }
  return {json[0].get<double>(), json[1].get<double>()};
}

Ring parsedRing(const Json& polygon)
{
  if (!polygon.is_array() || polygon.empty() || !polygon[0].is_array() || polygon[0].size() < 4)
  {
    throw FormatError("a polygon has no ring of four places or more");
  }
  Ring ring;
  ring.reserve(polygon[0].size());
  for (const Json& corner : polygon[0])
  {
    ring.push_back(parsedCorner(corner));
  }
  if (ring.front() != ring.back())
  {
    throw FormatError("a ring is not closed");
  }
  ring.pop_back();
  return ring;
}

Feature parsedFeature(const Json& json)
{
  Feature feature;
  const Json& geometry = json.at("geometry");
  const std::string type = geometry.is_object() ? geometry.value("type", "") : "";
  if (type == "Polygon")
  {
    feature.polygons.push_back(parsedRing(geometry.at("coordinates")));
  }
  else if (type == "MultiPolygon")
  {
    for (const Json& polygon : geometry.at("coordinates"))
    {
      feature.polygons.push_back(parsedRing(polygon));
    }
  }
  const Json properties = json.value("properties", Json::object());
  for (const auto& [key, value] : properties.items())
  {
    if (value.is_number())
    {
      feature.properties[key] = value.get<double>();
    }
    else if (value.is_string())
    {
      feature.properties[key] = value.get<std::string>();
    }
  }
  return feature;
}

Json parsedJson(std::string_view text)
{
  const auto refuse_depth = [](int depth, Json::parse_event_t /*event*/, Json& /*parsed*/)
  {
    constexpr int kDeepest = 16;
    if (depth > kDeepest)
    {
      throw FormatError("objects within objects, deeper than any polygon");
    }
    return true;
  };
  return Json::parse(text.begin(), text.end(), refuse_depth);
}

std::vector<Feature> parsedFeatures(std::string_view text)
{
  const Json json = parsedJson(text);
  if (!json.is_object() || json.value("type", "") != "FeatureCollection" ||
      !json.contains("features") || !json["features"].is_array())
  {
    throw FormatError("is no FeatureCollection");
  }
  std::vector<Feature> features;
  for (const Json& one : json["features"])
  {
    Feature feature = parsedFeature(one);
    if (!feature.polygons.empty())
    {
      features.push_back(std::move(feature));
    }
  }
  return features;
}
}  // namespace

std::string geoJson(const std::vector<Feature>& features)
{
  Json all = Json::array();
  for (const Feature& feature : features)
  {
    all.push_back(featureJson(feature));
  }
  const Json json = {
      {"type", "FeatureCollection"}, {"frame", "map, metres"}, {"features", std::move(all)}};
  return json.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::vector<Feature> parseGeoJson(std::string_view text, const std::string& name)
{
  try
  {
    return parsedFeatures(text);
  }
  catch (const FormatError& e)
  {
    throw FormatError(fmt::format("{}: {}", name, e.what()));
  }
  catch (const Json::exception& e)
  {
    throw FormatError(fmt::format("{}: is damaged or no GeoJSON ({})", name, e.id));
  }
}
}  // namespace traverse::formats
