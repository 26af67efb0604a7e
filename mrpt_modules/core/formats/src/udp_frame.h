// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace traverse::formats
{
/** What a captured frame holds. */
struct UdpFrame
{
  enum class Kind : uint8_t
  {
    datagram,
    fragment,
    other,  //!< anything else, also what is cut short or contradicts itself
  };

  Kind kind = Kind::other;
  uint16_t destination_port = 0;
  std::span<const uint8_t> payload;
};

/** True for the link types that parseFrame() takes apart. */
bool knowsLinkType(uint32_t link_type);

/** Finds the UDP payload in a frame; every length is checked before use. */
UdpFrame parseFrame(uint32_t link_type, std::span<const uint8_t> frame);
}  // namespace traverse::formats
