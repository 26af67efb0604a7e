// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "udp_frame.h"

#include <traverse/formats/pcap.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>
#include <vector>
#include <zlib.h>

namespace traverse::formats
{
namespace
{
using FileHeader = std::array<uint8_t, 24>;
using RecordHeader = std::array<uint8_t, 16>;

constexpr uint32_t kMagicMicroseconds = 0xA1B2C3D4;
constexpr uint32_t kMagicNanoseconds = 0xA1B23C4D;
constexpr uint32_t kMagicNextGeneration = 0x0A0D0D0A;
constexpr uint32_t kMaxRecordBytes = 262144;  // the limit of libpcap

struct GzClose
{
  void operator()(gzFile file) const { gzclose(file); }
};

using GzHandle = std::unique_ptr<std::remove_pointer_t<gzFile>, GzClose>;

uint32_t numberAt(std::span<const uint8_t> bytes, size_t at, bool big_endian)
{
  uint32_t value = 0;
  for (size_t i = 0; i < 4; ++i)
  {
    value = value << 8U | bytes[at + (big_endian ? i : 3 - i)];
  }
  return value;
}

/** What the file header says. */
struct Layout
{
  bool big_endian = false;
  uint32_t ticks_per_second = 1'000'000;
  uint32_t link_type = 0;
};

[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view why)
{
  throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
}

Layout layoutOf(const std::filesystem::path& file, const FileHeader& header)
{
  Layout layout;
  if (numberAt(header, 0, false) == kMagicNextGeneration)
  {
    refuse(file, "a pcapng file; only classic pcap is read (editcap -F pcap converts it)");
  }
  layout.big_endian = header[0] == 0xA1;
  const uint32_t magic = numberAt(header, 0, layout.big_endian);
  if (magic != kMagicMicroseconds && magic != kMagicNanoseconds)
  {
    refuse(file, "not a pcap file (its first four bytes are no pcap magic)");
  }
  layout.ticks_per_second = magic == kMagicNanoseconds ? 1'000'000'000 : 1'000'000;
  constexpr uint32_t kWithoutFcsBits = 0x03FFFFFF;
  layout.link_type = numberAt(header, 20, layout.big_endian) & kWithoutFcsBits;
  if (!knowsLinkType(layout.link_type))
  {
    refuse(
        file,
        fmt::format(
            "link type {} is not read (only Ethernet, Linux cooked and raw IP)", layout.link_type));
  }
  return layout;
}
}  // namespace

struct PcapReader::State
{
  std::filesystem::path file;
  GzHandle gz;
  Layout layout;
  std::vector<uint8_t> record;
  uint64_t offset = 0;  // of what is read next
  PcapReport report;

  /** Number of bytes read: fewer at the end of the file, -1 where gzip data are broken. */
  int read(std::span<uint8_t> into)
  {
    const int n = gzread(gz.get(), into.data(), static_cast<unsigned>(into.size()));
    offset += n > 0 ? static_cast<uint64_t>(n) : 0;
    return n;
  }

  void end(PcapEnd how, std::string_view why)
  {
    report.end = how;
    if (how != PcapEnd::clean)
    {
      report.message = fmt::format("{}: at byte {}: {}", file.string(), report.offset, why);
    }
  }

  void endShort(int n, std::string_view what)
  {
    int error = Z_OK;
    const char* text = gzerror(gz.get(), &error);
    if (n < 0 || (error != Z_OK && error != Z_BUF_ERROR))
    {
      end(PcapEnd::corrupt, fmt::format("broken gzip data: {}", text));
    }
    else if (n == 0 && error == Z_OK && what == "record header")
    {
      end(PcapEnd::clean, "");
    }
    else
    {
      end(PcapEnd::truncated, fmt::format("the file ends within a {}", what));
    }
  }

  /** Reads one record into `record`; its capture time, or nothing at the end. */
  std::optional<TimeNs> readRecord()
  {
    report.offset = offset;
    RecordHeader header{};
    int n = read(header);
    if (n != static_cast<int>(header.size()))
    {
      endShort(n, "record header");
      return std::nullopt;
    }
    const uint32_t seconds = numberAt(header, 0, layout.big_endian);
    const uint32_t ticks = numberAt(header, 4, layout.big_endian);
    const uint32_t length = numberAt(header, 8, layout.big_endian);
    if (length > kMaxRecordBytes || ticks >= layout.ticks_per_second)
    {
      end(PcapEnd::corrupt, length > kMaxRecordBytes
                                ? fmt::format("a record of {} bytes", length)
                                : fmt::format("a fraction of a second of {} ticks", ticks));
      return std::nullopt;
    }
    record.resize(length);
    n = read(record);
    if (n != static_cast<int>(length))
    {
      endShort(n, "record");
      return std::nullopt;
    }
    ++report.records;
    constexpr TimeNs kNsPerSecond = 1'000'000'000;
    return seconds * kNsPerSecond + ticks * (kNsPerSecond / layout.ticks_per_second);
  }
};

PcapReader::PcapReader(const std::filesystem::path& file) : state_(std::make_unique<State>())
{
  state_->file = file;
  if (std::filesystem::is_directory(file))
  {
    refuse(file, "a folder, not a pcap file");
  }
  errno = 0;
  state_->gz.reset(gzopen(file.c_str(), "rb"));
  if (!state_->gz)
  {
    refuse(file, fmt::format("cannot be opened: {}", std::strerror(errno)));
  }
  FileHeader header{};
  const int n = state_->read(header);
  if (n < 4)
  {
    refuse(file, "not a pcap file (too short, or broken gzip data)");
  }
  state_->layout = layoutOf(file, header);
  if (n != static_cast<int>(header.size()))
  {
    refuse(file, "the file ends within the pcap file header");
  }
}

PcapReader::~PcapReader() = default;
PcapReader::PcapReader(PcapReader&&) noexcept = default;
PcapReader& PcapReader::operator=(PcapReader&&) noexcept = default;

std::optional<UdpDatagram> PcapReader::next()
{
  PcapReport& report = state_->report;
  while (report.end == PcapEnd::not_yet)
  {
    const std::optional<TimeNs> time = state_->readRecord();
    if (!time)
    {
      break;
    }
    const UdpFrame frame = parseFrame(state_->layout.link_type, state_->record);
    if (frame.kind == UdpFrame::Kind::datagram)
    {
      ++report.datagrams;
      return UdpDatagram{*time, frame.destination_port, frame.payload};
    }
    ++(frame.kind == UdpFrame::Kind::fragment ? report.fragments : report.other);
  }
  return std::nullopt;
}

const PcapReport& PcapReader::report() const
{
  return state_->report;
}
}  // namespace traverse::formats
