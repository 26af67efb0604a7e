// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>

#include <fmt/format.h>
#include <limits>

namespace traverse::formats
{
void ByteWriter::str(std::string_view text)
{
  if (text.size() > std::numeric_limits<uint32_t>::max())
  {
    throw std::length_error("ByteWriter::str: a text longer than 4 GiB");
  }
  u32(static_cast<uint32_t>(text.size()));
  raw(text);
}

std::string ByteReader::str(size_t max_length)
{
  const uint32_t length = u32();
  if (length > max_length)
  {
    fail(fmt::format("a text of {} bytes, at most {} make sense", length, max_length));
  }
  return std::string(raw(length));
}

std::string_view ByteReader::raw(size_t length)
{
  if (length > remaining())
  {
    fail(fmt::format("{} bytes are needed, {} are left", length, remaining()));
  }
  const std::string_view part = bytes_.substr(next_, length);
  next_ += length;
  return part;
}

size_t ByteReader::count(size_t element_bytes)
{
  const uint64_t elements = u64();
  if (elements > remaining() / element_bytes)
  {
    fail(fmt::format(
        "a count of {} elements of {} bytes, but {} bytes are left", elements, element_bytes,
        remaining()));
  }
  return elements;
}

void ByteReader::expectEnd() const
{
  if (remaining() > 0)
  {
    fail(fmt::format("{} bytes follow the end", remaining()));
  }
}

void ByteReader::fail(const std::string& problem) const
{
  throw FormatError(fmt::format("{}, byte {}: {}", name_, position(), problem));
}
}  // namespace traverse::formats
