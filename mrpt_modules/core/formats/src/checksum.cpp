// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/checksum.h>

#include <zlib.h>

namespace traverse::formats
{
uint32_t crc32(std::string_view bytes)
{
  return static_cast<uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}
}  // namespace traverse::formats
