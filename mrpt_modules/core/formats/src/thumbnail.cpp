// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gdal_memory.h"

#include <traverse/formats/png.h>
#include <traverse/formats/run_index.h>

#include <algorithm>
#include <cpl_vsi.h>

namespace traverse::formats
{
namespace
{
/** The picture as rows of red, green, blue; averaged where it gets smaller. */
std::optional<Raster> shrunk(GDALDataset& picture, int width, int height)
{
  static_assert(sizeof(layers::Colour) == 3);
  Raster small(static_cast<size_t>(width), static_cast<size_t>(height));
  GDALRasterIOExtraArg how;
  INIT_RASTERIO_EXTRA_ARG(how);
  how.eResampleAlg = GRIORA_Average;
  const GSpacing pixel = sizeof(layers::Colour);
  const CPLErr read = picture.RasterIO(
      GF_Read, 0, 0, picture.GetRasterXSize(), picture.GetRasterYSize(), small.pixels.data(), width,
      height, GDT_Byte, 3, nullptr, pixel, pixel * width, 1, &how);
  return read == CE_None ? std::optional(std::move(small)) : std::nullopt;
}
}  // namespace

std::optional<std::string> thumbnail(const std::string& png_bytes, int width_px)
{
  constexpr int64_t kMostPixels = 64'000'000;
  const QuietGdal quiet;
  gdalDriver("PNG");
  const MemoryFile file(".png");
  // GDAL's signature is for writing, too; the file is only read here.
  auto* bytes = reinterpret_cast<GByte*>(const_cast<char*>(png_bytes.data()));
  VSILFILE* opened = VSIFileFromMemBuffer(file.path(), bytes, png_bytes.size(), FALSE);
  if (opened == nullptr)
  {
    return std::nullopt;
  }
  VSIFCloseL(opened);
  const char* const drivers[] = {"PNG", nullptr};
  const char* const siblings[] = {nullptr};  // no file beside it is looked for
  const Dataset picture(GDALDataset::Open(
      file.path(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, siblings));
  if (!picture || picture->GetRasterCount() < 3 ||
      picture->GetRasterBand(1)->GetRasterDataType() != GDT_Byte ||
      int64_t{picture->GetRasterXSize()} * picture->GetRasterYSize() > kMostPixels)
  {
    return std::nullopt;
  }
  const int width = std::min(width_px, picture->GetRasterXSize());
  const auto height =
      static_cast<int>(int64_t{picture->GetRasterYSize()} * width / picture->GetRasterXSize());
  const std::optional<Raster> small = shrunk(*picture, width, std::clamp(height, 1, 4 * width_px));
  return small ? std::optional(png(*small)) : std::nullopt;
}
}  // namespace traverse::formats
