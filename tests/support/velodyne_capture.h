// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/pcap.h>
#include <traverse/sensors/velodyne.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>
#include <zlib.h>

namespace traverse::testing
{
/** Velodyne packets and the views that the decoder takes. */
struct Capture
{
  std::vector<std::vector<uint8_t>> packets;

  std::vector<sensors::VelodynePacket> views() const { return {packets.begin(), packets.end()}; }

  /** Distances above 0 in all records: what a decoder without limits must yield (single return). */
  size_t rawReturns() const
  {
    size_t count = 0;
    for (const auto& packet : packets)
    {
      for (size_t record = 0; record < 384; ++record)
      {
        const size_t at = record / 32 * 100 + 4 + record % 32 * 3;
        count += packet[at] != 0 || packet[at + 1] != 0 ? 1 : 0;
      }
    }
    return count;
  }
};

/** The payloads of data packets' size. */
inline Capture captureInPcap(const std::filesystem::path& file)
{
  Capture capture;
  formats::PcapReader reader(file);
  while (const auto datagram = reader.next())
  {
    if (datagram->payload.size() == sensors::kVelodynePacketBytes)
    {
      capture.packets.emplace_back(datagram->payload.begin(), datagram->payload.end());
    }
  }
  return capture;
}

/** All bytes of a file that may be gzipped. */
inline std::vector<uint8_t> bytesOf(const std::filesystem::path& file)
{
  std::vector<uint8_t> bytes;
  gzFile gz = gzopen(file.c_str(), "rb");
  std::vector<uint8_t> part(1U << 16U);
  for (int n = 1; gz != nullptr && n > 0;)
  {
    n = gzread(gz, part.data(), static_cast<unsigned>(part.size()));
    bytes.insert(bytes.end(), part.begin(), part.begin() + std::max(n, 0));
  }
  gzclose(gz);
  return bytes;
}

/** The packets in a rawlog, found by the ids of their twelve blocks: no MRPT takes part. */
inline Capture captureInRawlog(const std::filesystem::path& file)
{
  const std::vector<uint8_t> bytes = bytesOf(file);
  const auto is_packet_at = [&](size_t at)
  {
    for (size_t block = 0; block < 12; ++block)
    {
      if (bytes[at + 100 * block] != 0xFF || bytes[at + 100 * block + 1] != 0xEE)
      {
        return false;
      }
    }
    return true;
  };
  Capture capture;
  for (size_t at = 0; at + sensors::kVelodynePacketBytes <= bytes.size();)
  {
    if (!is_packet_at(at))
    {
      ++at;
      continue;
    }
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    capture.packets.emplace_back(from, from + sensors::kVelodynePacketBytes);
    at += sensors::kVelodynePacketBytes;
  }
  return capture;
}
}  // namespace traverse::testing
