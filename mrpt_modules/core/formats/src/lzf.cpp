// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lzf.h"

#include <traverse/formats/bytes.h>

namespace traverse::formats
{
namespace
{
constexpr size_t kLiterals = 32;      // control bytes below: that many + 1 literal bytes follow
constexpr size_t kLongCopy = 7;       // the length goes on in another byte
constexpr size_t kMostPerByte = 100;  // 264 bytes out of 3 is the most that LZF can do
}  // namespace

std::string lzfDecompress(std::string_view input, size_t size)
{
  if (size / kMostPerByte > input.size())
  {
    throw FormatError("compressed data that are too short for what they announce");
  }
  std::string out;
  out.reserve(size);
  ByteReader in(input, "compressed data");
  while (in.remaining() > 0)
  {
    const size_t control = in.u8();
    if (control < kLiterals)
    {
      out += in.raw(control + 1);
    }
    else
    {
      size_t length = control >> 5U;
      length += length == kLongCopy ? in.u8() : 0;
      const size_t back = ((control & 31U) << 8U | in.u8()) + 1;
      if (back > out.size())
      {
        in.fail("a copy from before the start");
      }
      // Byte by byte: a copy may overlap what it makes.
      for (size_t i = 0; i < length + 2; ++i)
      {
        out += out[out.size() - back];
      }
    }
    if (out.size() > size)
    {
      in.fail("more than was announced");
    }
  }
  if (out.size() != size)
  {
    throw FormatError("compressed data that give less than was announced");
  }
  return out;
}
}  // namespace traverse::formats
