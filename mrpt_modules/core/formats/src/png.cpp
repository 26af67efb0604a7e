// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/checksum.h>
#include <traverse/formats/png.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <zlib.h>

namespace traverse::formats
{
namespace
{
constexpr size_t kBytesPerPixel = 3;

std::string bigEndian(size_t value)
{
  return {
      static_cast<char>(value >> 24U), static_cast<char>(value >> 16U),
      static_cast<char>(value >> 8U), static_cast<char>(value)};
}

std::string chunk(const std::string& type, const std::string& content)
{
  const std::string body = type + content;
  return bigEndian(content.size()) + body + bigEndian(crc32(body));
}

/** Each row is stored as the difference to the row above it, where there is one: flat areas and
 * enlarged cells become zeros. */
std::string filteredRows(const Raster& raster)
{
  constexpr char kNone = 0;
  constexpr char kUp = 2;
  std::string rows;
  rows.reserve(raster.height * (1 + kBytesPerPixel * raster.width));
  for (size_t row = 0; row < raster.height; ++row)
  {
    rows += row == 0 ? kNone : kUp;
    for (size_t column = 0; column < raster.width; ++column)
    {
      const layers::Colour c = raster.at(column, row);
      const layers::Colour up = row == 0 ? layers::Colour{} : raster.at(column, row - 1);
      rows += static_cast<char>(c.r - up.r);
      rows += static_cast<char>(c.g - up.g);
      rows += static_cast<char>(c.b - up.b);
    }
  }
  return rows;
}

std::string deflated(const std::string& bytes)
{
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(
          reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
          bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
  {
    throw std::runtime_error("png: zlib cannot compress");
  }
  out.resize(size);
  return out;
}

/** Colour of every code; white where the legend has none. */
std::array<layers::Colour, 256> colours(const layers::LayerSet& set)
{
  std::array<layers::Colour, 256> colour_of{};
  colour_of.fill({255, 255, 255});
  for (const layers::LegendEntry& entry : set.legend)
  {
    colour_of[entry.code] = entry.colour;
  }
  return colour_of;
}
}  // namespace

std::string png(const Raster& raster)
{
  constexpr size_t kMostPixels = std::numeric_limits<int32_t>::max() / kBytesPerPixel;
  if (raster.width == 0 || raster.height == 0 || raster.width > kMostPixels / raster.height ||
      raster.pixels.size() != raster.width * raster.height)
  {
    throw std::invalid_argument("png: a picture of no size, or with pixels for another one");
  }
  // 8 bits, RGB, deflate, adaptive filters, not interlaced.
  const std::string format("\x08\x02\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", bigEndian(raster.width) + bigEndian(raster.height) + format) +
         chunk("IDAT", deflated(filteredRows(raster))) + chunk("IEND", "");
}

Raster classPicture(const layers::LayerSet& set, size_t min_side_px)
{
  const layers::Layer* layer = set.find(set.class_layer);
  const auto* codes = layer == nullptr ? nullptr : std::get_if<std::vector<uint8_t>>(&layer->data);
  if (codes == nullptr || set.extent.empty() || codes->size() != set.size())
  {
    throw std::invalid_argument("classPicture: no class layer '" + set.class_layer + "'");
  }
  const auto width = static_cast<size_t>(set.extent.width());
  const auto height = static_cast<size_t>(set.extent.height());
  const size_t longer = std::max(width, height);
  const size_t zoom = std::max<size_t>(1, (min_side_px + longer - 1) / longer);
  const auto colour_of = colours(set);
  Raster raster(width * zoom, height * zoom);
  for (size_t row = 0; row < raster.height; ++row)
  {
    const size_t from = (height - 1 - row / zoom) * width;  // the top row has the largest y
    for (size_t column = 0; column < raster.width; ++column)
    {
      raster.at(column, row) = colour_of[(*codes)[from + column / zoom]];
    }
  }
  return raster;
}
}  // namespace traverse::formats
