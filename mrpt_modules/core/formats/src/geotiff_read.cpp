// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gdal_memory.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/geotiff_read.h>
#include <traverse/formats/safe_file.h>

#include <array>
#include <cmath>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <cstdlib>
#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
constexpr int64_t kMostCells = 25'000'000;
constexpr size_t kLargestFile = size_t{1} << 30U;

/** The dataset of bytes that outlive it. */
Dataset open(const MemoryFile& file, std::string_view bytes)
{
  // GDAL's signature takes writable bytes; the file is opened for reading only
  auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
  VSILFILE* handle = VSIFileFromMemBuffer(file.path(), data, bytes.size(), FALSE);
  if (handle == nullptr)
  {
    throw FormatError("GDAL has no room for it");
  }
  VSIFCloseL(handle);
  gdalDriver("GTiff");  // registers
  const std::array<const char*, 2> drivers = {"GTiff", nullptr};
  const std::array<const char*, 1> no_side_files = {nullptr};
  Dataset dataset(GDALDataset::Open(
      file.path(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data(), nullptr,
      no_side_files.data()));
  if (!dataset)
  {
    throw FormatError("is no GeoTIFF, or damaged");
  }
  return dataset;
}

/** A length that is a whole number of units (> 0), to a millionth of one. */
int64_t whole(double length, double unit, const char* what)
{
  const double count = length / unit;
  const double nearest = std::round(count);
  constexpr double kSlack = 1e-6;
  constexpr double kMost = 2e9;
  if (!(std::abs(nearest) <= kMost) || std::abs(count - nearest) > kSlack)
  {
    throw FormatError(fmt::format("{} on the lattice of whole millimetres", what));
  }
  return static_cast<int64_t>(nearest);
}

void place(GDALDataset& dataset, layers::LayerSet& set)
{
  constexpr double kMm = 1 / geometry::kMillimetresPerMetre;
  std::array<double, 6> t{};
  if (dataset.GetGeoTransform(t.data()) != CE_None)
  {
    throw FormatError("does not say where its cells are");
  }
  if (t[2] != 0 || t[4] != 0 || !(t[1] > 0) || t[5] != -t[1])
  {
    throw FormatError("its cells are turned, oblong, or not north up");
  }
  constexpr int64_t kLargestCell_mm = 1'000'000;
  const int64_t cell_mm = whole(t[1], kMm, "its cells' size is not");
  if (cell_mm < 1 || cell_mm > kLargestCell_mm)
  {
    throw FormatError("its cells are smaller than 1 mm or larger than 1 km");
  }
  set.lattice.cell_mm = static_cast<int32_t>(cell_mm);
  const double cell_m = set.lattice.cell_m();
  const int64_t left = whole(t[0], cell_m, "its cells do not lie");
  const int64_t top = whole(t[3], cell_m, "its cells do not lie");
  set.extent = {
      {static_cast<int32_t>(left), static_cast<int32_t>(top - dataset.GetRasterYSize())},
      {static_cast<int32_t>(left + dataset.GetRasterXSize()), static_cast<int32_t>(top)}};
}

void checkShape(GDALDataset& dataset)
{
  if (dataset.GetRasterCount() != 1)
  {
    throw FormatError(fmt::format("has {} bands instead of one", dataset.GetRasterCount()));
  }
  const int64_t width = dataset.GetRasterXSize();
  const int64_t height = dataset.GetRasterYSize();
  if (width < 1 || height < 1 || width > kMostCells || height > kMostCells ||
      width * height > kMostCells)
  {
    throw FormatError(fmt::format("has {} x {} cells, more than {}", width, height, kMostCells));
  }
}

template <class T>
std::vector<T> cellsOf(GDALRasterBand& band, GDALDataType type)
{
  const int width = band.GetXSize();
  const int height = band.GetYSize();
  std::vector<T> cells(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int row = 0; row < height; ++row)
  {
    T* to = cells.data() + static_cast<size_t>(height - 1 - row) * static_cast<size_t>(width);
    if (band.RasterIO(GF_Read, 0, row, width, 1, to, width, 1, type, 0, 0, nullptr) != CE_None)
    {
      throw FormatError("is damaged: its cells cannot be read");
    }
  }
  return cells;
}

void readCells(GDALRasterBand& band, layers::Layer& layer)
{
  switch (band.GetRasterDataType())
  {
    case GDT_Byte:
      layer.data = cellsOf<uint8_t>(band, GDT_Byte);
      return;
    case GDT_UInt32:
      layer.data = cellsOf<uint32_t>(band, GDT_UInt32);
      return;
    case GDT_Float32:
      layer.data = cellsOf<float>(band, GDT_Float32);
      return;
    case GDT_Float64:
      layer.data = cellsOf<double>(band, GDT_Float64);
      return;
    default:
      throw FormatError("its cells are neither uint8, uint32, float32 nor float64");
  }
}

std::vector<layers::LegendEntry> legendOf(GDALDataset& dataset)
{
  const GDALColorTable* table = dataset.GetRasterBand(1)->GetColorTable();
  std::vector<layers::LegendEntry> legend;
  for (int code = 0; code < 256; ++code)
  {
    const char* name = dataset.GetMetadataItem(fmt::format("CLASS_{}", code).c_str());
    if (name == nullptr)
    {
      continue;
    }
    const GDALColorEntry* c = table == nullptr || code >= table->GetColorEntryCount()
                                  ? nullptr
                                  : table->GetColorEntry(code);
    const auto byte = [](short v) { return static_cast<uint8_t>(v); };
    legend.push_back(
        {static_cast<uint8_t>(code), name,
         c == nullptr ? layers::Colour{} : layers::Colour{byte(c->c1), byte(c->c2), byte(c->c3)}});
  }
  return legend;
}

layers::LayerSet parsed(std::string_view bytes, const std::string& name)
{
  const QuietGdal quiet;
  const MemoryFile file(".tif");
  const Dataset dataset = open(file, bytes);
  checkShape(*dataset);
  layers::LayerSet set;
  place(*dataset, set);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  const std::string described = band.GetDescription();
  layers::Layer layer{described.empty() ? name : described, band.GetUnitType(), {}};
  readCells(band, layer);
  if (std::holds_alternative<std::vector<uint8_t>>(layer.data))
  {
    set.legend = legendOf(*dataset);
    set.class_layer = set.legend.empty() ? "" : layer.name;
  }
  set.layers.push_back(std::move(layer));
  return set;
}

void join(layers::LayerSet& all, layers::LayerSet one)
{
  if (all.layers.empty())
  {
    all = std::move(one);
    return;
  }
  if (!(all.lattice == one.lattice) || !(all.extent == one.extent))
  {
    throw FormatError("lies on other cells than the files before it");
  }
  if (all.find(one.layers[0].name) != nullptr)
  {
    throw FormatError(fmt::format("has layer '{}', which was there already", one.layers[0].name));
  }
  if (all.class_layer.empty())
  {
    all.class_layer = one.class_layer;
    all.legend = std::move(one.legend);
  }
  all.layers.push_back(std::move(one.layers[0]));
}
}  // namespace

layers::LayerSet parseGeoTiff(std::string_view bytes, const std::string& name)
{
  try
  {
    return parsed(bytes, name);
  }
  catch (const FormatError& e)
  {
    throw FormatError(fmt::format("'{}' {}", name, e.what()));
  }
}

layers::LayerSet readGeoTiffs(const std::vector<std::filesystem::path>& files)
{
  layers::LayerSet all;
  for (const std::filesystem::path& file : files)
  {
    try
    {
      join(all, parsed(readFile(file, kLargestFile), file.stem().string()));
    }
    catch (const FormatError& e)
    {
      throw FormatError(fmt::format("'{}' {}", file.string(), e.what()));
    }
    catch (const FileError& e)
    {
      throw FormatError(e.what());
    }
  }
  return all;
}
}  // namespace traverse::formats
