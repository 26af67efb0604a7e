// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace traverse::formats
{
using poses::TimeNs;

/** One UDP datagram of a capture. */
struct UdpDatagram
{
  TimeNs time = 0;  //!< when it was captured
  uint16_t destination_port = 0;
  std::span<const uint8_t> payload;  //!< valid until the next call of next()
};

/** How reading a capture ended. */
enum class PcapEnd : uint8_t
{
  not_yet,
  clean,      //!< behind a whole record
  truncated,  //!< within a record
  corrupt,    //!< a record that cannot be, or broken gzip data
};

/** What was read so far. */
struct PcapReport
{
  PcapEnd end = PcapEnd::not_yet;
  uint64_t offset = 0;  //!< of the record that was read last, or is broken; uncompressed bytes
  std::string message;  //!< names file, offset and fault where the end is truncated or corrupt
  uint64_t records = 0;
  uint64_t datagrams = 0;
  uint64_t fragments = 0;  //!< skipped: parts of a datagram
  uint64_t other = 0;      //!< skipped: not IPv4 with UDP, or cut short by the capture
};

/** Reads UDP over IPv4 from a classic pcap file (micro- or nanoseconds, either byte order;
 * Ethernet with VLAN tags, Linux cooked, or raw IP), plain or gzipped, one record at a time. */
class PcapReader
{
 public:
  /** Throws std::runtime_error, naming the file and why, where it cannot be opened or is none that
   * is understood (pcapng, another link type, anything else). */
  explicit PcapReader(const std::filesystem::path& file);
  ~PcapReader();
  PcapReader(PcapReader&&) noexcept;
  PcapReader& operator=(PcapReader&&) noexcept;
  PcapReader(const PcapReader&) = delete;
  PcapReader& operator=(const PcapReader&) = delete;

  /** The next datagram; nothing at the end, of which report() says whether it is a clean one. */
  std::optional<UdpDatagram> next();

  const PcapReport& report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};
}  // namespace traverse::formats
