// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace traverse::testing
{
/** Pieces of capture files, made by hand. */
using Bytes = std::vector<uint8_t>;

inline void append(Bytes& to, const Bytes& what)
{
  to.insert(to.end(), what.begin(), what.end());
}

inline Bytes number(uint32_t value, bool big_endian = false)
{
  Bytes bytes;
  for (unsigned i = 0; i < 4; ++i)
  {
    bytes.push_back(static_cast<uint8_t>(value >> 8U * (big_endian ? 3 - i : i)));
  }
  return bytes;
}

inline Bytes fileHeader(uint32_t link_type, uint32_t magic = 0xA1B2C3D4, bool big_endian = false)
{
  Bytes bytes;
  const uint32_t version = big_endian ? 0x00020004 : 0x00040002;
  for (const uint32_t value : {magic, version, 0U, 0U, 65535U, link_type})
  {
    append(bytes, number(value, big_endian));
  }
  return bytes;
}

inline Bytes record(const Bytes& frame, uint32_t ticks = 500, bool big_endian = false)
{
  Bytes bytes;
  const auto size = static_cast<uint32_t>(frame.size());
  for (const uint32_t value : {1'600'000'000U, ticks, size, size})
  {
    append(bytes, number(value, big_endian));
  }
  append(bytes, frame);
  return bytes;
}

inline Bytes udpInIp(const Bytes& payload, uint8_t fragment_flags = 0)
{
  const auto length = static_cast<uint8_t>(28 + payload.size());
  Bytes ip = {
      0x45,
      0,
      0,
      length,
      0,
      0,
      fragment_flags,
      0,
      64,
      17,
      0,
      0,
      10,
      0,
      0,
      1,
      10,
      0,
      0,
      2,
      0x12,
      34,
      9,
      64,
      0,
      static_cast<uint8_t>(8 + payload.size()),
      0,
      0};
  append(ip, payload);
  return ip;
}

inline Bytes ethernet(const Bytes& between, const Bytes& ip)
{
  Bytes frame(12, 0xEE);
  append(frame, between);
  append(frame, ip);
  return frame;
}

inline const Bytes ipv4_type = {0x08, 0x00};
inline const Bytes sample_payload = {1, 2, 3, 4, 5};
}  // namespace traverse::testing
