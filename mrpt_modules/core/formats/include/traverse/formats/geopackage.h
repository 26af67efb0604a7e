// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <array>
#include <span>
#include <string>

namespace traverse::formats
{
/** The bytes of a GeoPackage (SQLite) for QGIS and its like.
 *
 * Table `cells`: a square per cell of which any layer says anything, with cell_x, cell_y,
 * class_name, colour ("#rrggbb") and every layer under its name, as the very number that the layer
 * has; unknown (NaN) is NULL. It is a table of features and not of raster tiles, as a GeoPackage's
 * tiles hold neither doubles nor 32-bit counts. Table `trajectory`, where there are two points or
 * more: one line. Both in metres of the map frame, in the local system of geoTiff().
 *
 * No clock: the same map gives the same bytes with the same GDAL and SQLite. Throws
 * std::invalid_argument where a layer is not of the extent's size, FormatError where GDAL refuses.
 */
std::string geoPackage(
    const layers::LayerSet& set, std::span<const std::array<double, 3>> trajectory_m);
}  // namespace traverse::formats
