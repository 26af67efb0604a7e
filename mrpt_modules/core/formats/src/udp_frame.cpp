// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "udp_frame.h"

#include <algorithm>
#include <array>

namespace traverse::formats
{
namespace
{
using Bytes = std::span<const uint8_t>;

constexpr uint32_t kEthernet = 1;
constexpr uint32_t kLinuxCooked = 113;
constexpr std::array<uint32_t, 4> kRawIp = {12, 14, 101, 228};
constexpr uint16_t kEtherTypeIpv4 = 0x0800;
constexpr size_t kMaxVlanTags = 4;
constexpr uint8_t kProtocolUdp = 17;

uint16_t bigEndian16(Bytes bytes, size_t at)
{
  return static_cast<uint16_t>(bytes[at] << 8 | bytes[at + 1]);
}

bool isVlanTag(uint16_t ether_type)
{
  return ether_type == 0x8100 || ether_type == 0x88A8 || ether_type == 0x9100;
}

/** What follows an EtherType at a place, behind VLAN tags, if it is IPv4; empty otherwise. */
Bytes ipv4Behind(Bytes frame, size_t ether_type_at)
{
  for (size_t tags = 0; tags <= kMaxVlanTags && ether_type_at + 2 <= frame.size(); ++tags)
  {
    const uint16_t ether_type = bigEndian16(frame, ether_type_at);
    if (ether_type == kEtherTypeIpv4)
    {
      return frame.subspan(ether_type_at + 2);
    }
    if (!isVlanTag(ether_type))
    {
      break;
    }
    ether_type_at += 4;
  }
  return {};
}

Bytes ipOf(uint32_t link_type, Bytes frame)
{
  switch (link_type)
  {
    case kEthernet:
      return ipv4Behind(frame, 12);
    case kLinuxCooked:
      return ipv4Behind(frame, 14);
    default:
      return frame;
  }
}

UdpFrame udpOf(Bytes segment)
{
  constexpr size_t kHeader = 8;
  if (segment.size() < kHeader)
  {
    return {};
  }
  const size_t length = bigEndian16(segment, 4);
  if (length < kHeader || length > segment.size())
  {
    return {};
  }
  return {
      UdpFrame::Kind::datagram, bigEndian16(segment, 2),
      segment.subspan(kHeader, length - kHeader)};
}
}  // namespace

bool knowsLinkType(uint32_t link_type)
{
  return link_type == kEthernet || link_type == kLinuxCooked ||
         std::find(kRawIp.begin(), kRawIp.end(), link_type) != kRawIp.end();
}

UdpFrame parseFrame(uint32_t link_type, std::span<const uint8_t> frame)
{
  constexpr size_t kShortestHeader = 20;
  const Bytes ip = ipOf(link_type, frame);
  if (ip.size() < kShortestHeader || ip[0] >> 4 != 4 || ip[9] != kProtocolUdp)
  {
    return {};
  }
  const size_t header = size_t{ip[0] & 0x0FU} * 4;
  const size_t total = bigEndian16(ip, 2);
  if (header < kShortestHeader || total < header || total > ip.size())
  {
    return {};
  }
  constexpr unsigned kMoreFragmentsOrOffset = 0x3FFF;
  if ((bigEndian16(ip, 6) & kMoreFragmentsOrOffset) != 0)
  {
    return {UdpFrame::Kind::fragment, 0, {}};
  }
  return udpOf(ip.subspan(header, total - header));
}
}  // namespace traverse::formats
