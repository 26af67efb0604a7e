// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <string>

namespace traverse::formats
{
/** The bytes of a GeoTIFF with one layer, north up (the first row has the largest y).
 *
 * Georeferenced in metres of the map frame, in a local (engineering) coordinate system named "map":
 * the frame is not tied to the earth, and a made-up geographic system would lie. One band of the
 * layer's own type (uint8, uint32, float32, float64), deflated. Unknown is NaN in floating layers
 * and 0 in the class layer, both marked as nodata; other integer layers have no nodata. The class
 * layer carries its legend: colours as a palette, names as metadata CLASS_<code>. The band is
 * named by the layer, with its unit. The same layer gives the same bytes.
 *
 * Throws std::invalid_argument where the extent is empty or the layer is not of its size, and
 * FormatError where GDAL refuses. */
std::string geoTiff(const layers::LayerSet& set, const layers::Layer& layer);
}  // namespace traverse::formats
