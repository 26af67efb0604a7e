// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** One layer from the bytes of a GeoTIFF as geoTiff() writes them, with lattice and extent, and the
 * legend where it is a class layer. The layer has the band's name, or `name` where that is empty.
 *
 * The bytes may be hostile: GDAL's GTiff driver alone sees them, in memory. Throws FormatError,
 * naming `name`, for other formats, more than one band, types other than uint8, uint32, float32 and
 * float64, rotated or oblong cells, cells that do not lie on the lattice of whole millimetres, more
 * than 25 million of them, and damage. */
layers::LayerSet parseGeoTiff(std::string_view bytes, const std::string& name);

/** The layers of files that lie on the same cells, in their order; the class layer is the first
 * with a legend. Throws FormatError also where a file cannot be read, is larger than 1 GiB, lies on
 * other cells, or has a layer that was there already. */
layers::LayerSet readGeoTiffs(const std::vector<std::filesystem::path>& files);
}  // namespace traverse::formats
