// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/checksum.h>
#include <traverse/formats/safe_file.h>

#include <cerrno>
#include <fstream>
#include <vector>
#include <zlib.h>

namespace traverse::formats
{
uint32_t crc32(std::string_view bytes)
{
  return static_cast<uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

uint32_t crc32OfFile(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::vector<char> part(size_t{1} << 20U);
  uLong crc = 0;
  while (in)
  {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    crc =
        crc32_z(crc, reinterpret_cast<const Bytef*>(part.data()), static_cast<size_t>(in.gcount()));
  }
  if (!in.eof() || in.bad())
  {
    throw FileError("read", file, errno);
  }
  return static_cast<uint32_t>(crc);
}
}  // namespace traverse::formats
