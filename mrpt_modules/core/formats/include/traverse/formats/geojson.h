// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace traverse::formats
{
/** Corners of a polygon without holes, m in the map frame; the first one is not repeated. */
using Ring = std::vector<Eigen::Vector2d>;

/** A thing with a place and properties. */
struct Feature
{
  std::vector<Ring> polygons;
  std::map<std::string, std::variant<double, std::string>> properties;
};

/** A FeatureCollection of MultiPolygons. Coordinates are metres of the map frame, which is not tied
 * to the earth, rounded to 1 um; a member "frame" of the collection says so (RFC 7946 would have
 * degrees of WGS 84; QGIS takes the file as it is once told "no CRS"). Numbers that are not finite
 * become null. The same features give the same bytes. Throws std::invalid_argument for a ring of
 * fewer than three corners. */
std::string geoJson(const std::vector<Feature>& features);

/** Reads a FeatureCollection of Polygons and MultiPolygons, of anybody: outer rings only, features
 * of other geometries are left out, properties that are neither numbers nor texts too. Throws
 * FormatError, naming `name`, for what is no such JSON, deeper than 16 levels, coordinates that are
 * no finite numbers within 1e8 m, and rings that are not closed. */
std::vector<Feature> parseGeoJson(std::string_view text, const std::string& name);
}  // namespace traverse::formats
