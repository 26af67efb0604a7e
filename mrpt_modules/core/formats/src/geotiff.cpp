// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gdal_memory.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/geotiff.h>

#include <array>
#include <cpl_error.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
template <class T>
constexpr GDALDataType kGdalType = GDT_Unknown;
template <>
constexpr GDALDataType kGdalType<uint8_t> = GDT_Byte;
template <>
constexpr GDALDataType kGdalType<uint32_t> = GDT_UInt32;
template <>
constexpr GDALDataType kGdalType<float> = GDT_Float32;
template <>
constexpr GDALDataType kGdalType<double> = GDT_Float64;

[[noreturn]] void refuse(const std::string& layer)
{
  throw FormatError(fmt::format("GeoTIFF of '{}': {}", layer, CPLGetLastErrorMsg()));
}

Dataset create(const MemoryFile& file, const layers::LayerSet& set, GDALDataType type)
{
  const bool floating = type == GDT_Float32 || type == GDT_Float64;
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", floating ? "3" : "2");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  return Dataset(gdalDriver("GTiff").Create(
      file.path(), set.extent.width(), set.extent.height(), 1, type, options.List()));
}

bool placeOnMap(GDALDataset& dataset, const layers::LayerSet& set)
{
  const geometry::Lattice& lattice = set.lattice;
  std::array<double, 6> transform = {
      lattice.edge_m(set.extent.min.x),
      lattice.cell_m(),
      0,
      lattice.edge_m(set.extent.max.y),
      0,
      -lattice.cell_m()};
  OGRSpatialReference reference;
  return setMapFrame(reference) && dataset.SetGeoTransform(transform.data()) == CE_None &&
         dataset.SetSpatialRef(&reference) == CE_None;
}

/** Palette and names of the class layer. */
bool addLegend(GDALDataset& dataset, const layers::LayerSet& set)
{
  GDALColorTable table;
  bool good = true;
  for (const layers::LegendEntry& entry : set.legend)
  {
    const GDALColorEntry colour = {entry.colour.r, entry.colour.g, entry.colour.b, 255};
    table.SetColorEntry(entry.code, &colour);
    good = good && dataset.SetMetadataItem(
                       fmt::format("CLASS_{}", entry.code).c_str(), entry.name.c_str()) == CE_None;
  }
  return good && dataset.GetRasterBand(1)->SetColorTable(&table) == CE_None;
}

template <class T>
bool writeRows(GDALDataset& dataset, const layers::LayerSet& set, const std::vector<T>& cells)
{
  const int width = set.extent.width();
  const int height = set.extent.height();
  for (int row = 0; row < height; ++row)
  {
    // GDAL's signature takes a writable pointer for reading and writing alike; it only reads here.
    T* from = const_cast<T*>(cells.data()) + static_cast<size_t>(height - 1 - row) * width;
    if (dataset.GetRasterBand(1)->RasterIO(
            GF_Write, 0, row, width, 1, from, width, 1, kGdalType<T>, 0, 0, nullptr) != CE_None)
    {
      return false;
    }
  }
  return true;
}

template <class T>
std::string encode(
    const layers::LayerSet& set, const layers::Layer& layer, const std::vector<T>& cells)
{
  const QuietGdal quiet;
  const MemoryFile file(".tif");
  Dataset dataset = create(file, set, kGdalType<T>);
  if (!dataset || !placeOnMap(*dataset, set))
  {
    refuse(layer.name);
  }
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  const bool is_class = layer.name == set.class_layer && std::is_same_v<T, uint8_t>;
  bool good = true;
  if (is_class)
  {
    good = addLegend(*dataset, set) && band.SetNoDataValue(0) == CE_None;
  }
  else if (std::is_floating_point_v<T>)
  {
    good = band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN()) == CE_None;
  }
  band.SetDescription(layer.name.c_str());
  good = good && band.SetUnitType(layer.unit.c_str()) == CE_None && writeRows(*dataset, set, cells);
  dataset.reset();  // writes the rest; its only word about failure is the last error
  if (!good || quiet.failed())
  {
    refuse(layer.name);
  }
  return file.take();
}
}  // namespace

std::string geoTiff(const layers::LayerSet& set, const layers::Layer& layer)
{
  return std::visit(
      [&](const auto& cells)
      {
        if (set.extent.empty() || cells.size() != set.size())
        {
          throw std::invalid_argument(fmt::format(
              "GeoTIFF of '{}': {} cells for an extent of {} x {}", layer.name, cells.size(),
              set.extent.width(), set.extent.height()));
        }
        return encode(set, layer, cells);
      },
      layer.data);
}
}  // namespace traverse::formats
