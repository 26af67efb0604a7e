// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image_size.h"

#include <traverse/formats/safe_file.h>
#include <traverse/importing/source.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace traverse::importing
{
namespace
{
constexpr uint32_t kLongestSide = 16384;
constexpr size_t kLargestFile = 1U << 28U;

struct Size
{
  uint32_t width = 0;
  uint32_t height = 0;
};

/** A big-endian number of n bytes; 0 beyond the end. */
uint32_t bigEndian(std::string_view bytes, size_t at, size_t n)
{
  uint32_t value = 0;
  for (size_t i = 0; i < n; ++i)
  {
    value = value << 8U | (at + i < bytes.size() ? static_cast<uint8_t>(bytes[at + i]) : 0U);
  }
  return value;
}

/** Walks the markers of a JPEG to the frame header. */
Size jpegSize(std::string_view bytes)
{
  size_t at = 2;
  while (at + 9 < bytes.size() && bytes[at] == '\xFF')
  {
    const uint32_t marker = bigEndian(bytes, at + 1, 1);
    const bool frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (frame)
    {
      return {bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
    }
    at += 2 + bigEndian(bytes, at + 2, 2);
  }
  return {};
}

Size pictureSize(std::string_view bytes)
{
  if (bytes.substr(0, 8) == std::string_view("\x89PNG\r\n\x1a\n", 8))
  {
    return {bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
  }
  return bytes.substr(0, 2) == "\xFF\xD8" ? jpegSize(bytes) : Size{};
}
}  // namespace

void checkPicture(const std::filesystem::path& file)
{
  const std::string bytes = formats::readFile(file, kLargestFile);
  const Size size = pictureSize(bytes);
  if (size.width < 1 || size.height < 1 || size.width > kLongestSide || size.height > kLongestSide)
  {
    throw ImportError(file.string() + ": is no PNG or JPEG picture of sane size");
  }
}
}  // namespace traverse::importing
