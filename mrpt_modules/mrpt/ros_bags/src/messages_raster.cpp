// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"

#include <fmt/format.h>

// Messages whose data is rows of elements: what they say of their layout is checked here, once.
namespace traverse::ros_bags
{
namespace
{
constexpr uint64_t kMostElements = uint64_t{1} << 28U;

/** Rows of `row_bytes`, `step` apart, must lie within `data`. */
void checkRows(
    const MessageBytes& in, std::string_view data, uint64_t rows, uint64_t row_bytes, uint64_t step)
{
  if (rows == 0 || row_bytes == 0)
  {
    return;
  }
  if (rows > 1 && step < row_bytes)
  {
    in.fail(fmt::format("rows of {} bytes do not fit a step of {}", row_bytes, step));
  }
  // No overflow: each factor is below 2^32.
  if ((rows - 1) * step > data.size() || row_bytes > data.size() - (rows - 1) * step)
  {
    in.fail(fmt::format("{} rows of {} bytes, but {} bytes of data", rows, step, data.size()));
  }
}

uint32_t sizeOf(uint8_t type)
{
  constexpr std::array<uint32_t, 9> kSizes = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  return type < kSizes.size() ? kSizes[type] : 0;
}

PointField readField(MessageBytes& in)
{
  PointField field;
  field.name = in.text();
  field.offset = in.u32();
  field.type = in.u8();
  in.u32();  // count: the first element of a field of several is taken
  return field;
}
}  // namespace

PointCloud parsePointCloud(std::string_view bytes)
{
  MessageBytes in(bytes, "PointCloud2");
  PointCloud cloud;
  cloud.header = in.header();
  cloud.height = in.u32();
  cloud.width = in.u32();
  constexpr size_t kLeastField = 13;
  cloud.fields.resize(in.elements(kLeastField));
  for (PointField& field : cloud.fields)
  {
    field = readField(in);
  }
  cloud.big_endian = in.u8() != 0;
  cloud.point_step = in.u32();
  cloud.row_step = in.u32();
  cloud.data = in.blob();
  in.u8();  // is_dense: drivers say it wrongly, we look at the points
  in.expectEnd();
  for (const PointField& field : cloud.fields)
  {
    const uint64_t size = sizeOf(field.type);
    if (size == 0 || field.offset + size > cloud.point_step)
    {
      in.fail("a field that does not lie within its point");
    }
  }
  const uint64_t points = uint64_t{cloud.width} * cloud.height;
  if (points > kMostElements || uint64_t{cloud.width} * cloud.point_step > UINT32_MAX)
  {
    in.fail("an absurd number of points");
  }
  if (points == 0)
  {
    cloud.height = cloud.width = 0;  // nobody shall walk four billion empty rows
  }
  if (points > 0 && cloud.point_step == 0)
  {
    in.fail("points without fields");
  }
  checkRows(in, cloud.data, cloud.height, uint64_t{cloud.width} * cloud.point_step, cloud.row_step);
  return cloud;
}

Image parseImage(std::string_view bytes)
{
  MessageBytes in(bytes, "Image");
  Image image;
  image.header = in.header();
  image.height = in.u32();
  image.width = in.u32();
  image.encoding = in.text();
  image.big_endian = in.u8() != 0;
  image.step = in.u32();
  image.data = in.blob();
  in.expectEnd();
  constexpr uint32_t kLongestSide = 1U << 15U;
  if (image.width > kLongestSide || image.height > kLongestSide)
  {
    in.fail("an absurd size");
  }
  // Of what each pixel has at least one byte; the decoder of an encoding knows how many.
  checkRows(in, image.data, image.height, image.step, image.step);
  return image;
}
}  // namespace traverse::ros_bags
