// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/geotiff.h>

#include <array>
#include <atomic>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <limits>
#include <memory>
#include <mutex>
#include <ogr_spatialref.h>
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

/** Keeps GDAL from printing, for this scope and thread. */
struct QuietGdal
{
  QuietGdal()
  {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }

  ~QuietGdal() { CPLPopErrorHandler(); }

  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

[[noreturn]] void refuse(const std::string& layer)
{
  throw FormatError(fmt::format("GeoTIFF of '{}': {}", layer, CPLGetLastErrorMsg()));
}

/** A file in GDAL's memory: there a full disk cannot be missed. */
class MemoryFile
{
 public:
  MemoryFile()
  {
    static std::atomic<unsigned> calls = 0;
    path_ = fmt::format("/vsimem/traverse-{}.tif", calls++);
  }

  ~MemoryFile() { VSIUnlink(path_.c_str()); }

  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const char* path() const { return path_.c_str(); }

  std::string take() const
  {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
    return bytes == nullptr ? std::string()
                            : std::string(reinterpret_cast<const char*>(bytes), size);
  }

 private:
  std::string path_;
};

struct CloseDataset
{
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

Dataset create(const MemoryFile& file, const layers::LayerSet& set, GDALDataType type)
{
  static std::once_flag registered;
  std::call_once(registered, GDALAllRegister);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (driver == nullptr)
  {
    throw FormatError("GDAL has no GTiff driver");
  }
  const bool floating = type == GDT_Float32 || type == GDT_Float64;
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", floating ? "3" : "2");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  return Dataset(driver->Create(
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
  return reference.SetFromUserInput(R"(LOCAL_CS["map",UNIT["metre",1]])") == OGRERR_NONE &&
         dataset.SetGeoTransform(transform.data()) == CE_None &&
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
  const MemoryFile file;
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
  if (!good || CPLGetLastErrorType() >= CE_Failure)
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
