// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

// The numbers of the layout drawn at ChannelsWriter.
namespace traverse::formats::channels
{
inline constexpr std::string_view kMagic("\x89TRCH\r\n\x1a", 8);
inline constexpr uint32_t kVersion = 1;
inline constexpr uint32_t kCloudMark = 0x44554C43;  // "CLUD"
inline constexpr uint32_t kEndMark = 0x444E4543;    // "CEND"
inline constexpr uint32_t kRing = 1;
inline constexpr uint32_t kTime = 2;
inline constexpr uint32_t kLongestLabel = 1024;
inline constexpr uint32_t kMostPoints = 1U << 28U;
inline constexpr size_t kPrefixBytes = 12;  // magic and version
inline constexpr size_t kHeadBytes = 28;    // of a cloud, before the label
inline constexpr size_t kEndBytes = 16;
inline constexpr int64_t kTickNs = 100;

inline size_t payloadBytes(uint32_t flags, uint32_t points)
{
  const size_t each = ((flags & kRing) != 0 ? 2 : 0) + ((flags & kTime) != 0 ? 4 : 0);
  return each * points;
}
}  // namespace traverse::formats::channels
