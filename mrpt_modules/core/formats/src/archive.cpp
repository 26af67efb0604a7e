// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/archive.h>
#include <traverse/formats/checksum.h>

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace traverse::formats
{
namespace
{
constexpr std::string_view kMagic = "\x89TRAV\r\n\x1a";
constexpr size_t kMaxKind = 64;
constexpr size_t kNameBytes = 4;
constexpr size_t kCrcBytes = 4;
constexpr size_t kSectionHeader = kNameBytes + sizeof(uint64_t) + kCrcBytes;
constexpr size_t kSizeAt = 12;  // of the u64 with the size of the whole

/** The name where it is printable, for messages about hostile bytes. */
std::string shown(std::string_view name)
{
  std::string text;
  for (const char c : name)
  {
    text += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", uint8_t(c));
  }
  return text;
}

/** Magic, layout version and size: what is checked before anything else is believed. */
void checkFrame(std::string_view bytes)
{
  if (!bytes.starts_with(kMagic))
  {
    throw FormatError(
        bytes.empty() ? "not a Traverse archive: empty"
                      : "not a Traverse archive: its first 8 bytes are others");
  }
  ByteReader in(bytes, "archive");
  in.raw(kMagic.size());
  const uint32_t container_version = in.u32();
  const uint64_t size = in.u64();
  if (size > bytes.size())
  {
    throw FormatError(
        fmt::format("archive truncated: {} of {} bytes are there", bytes.size(), size));
  }
  if (size < bytes.size())
  {
    throw FormatError(
        fmt::format("archive, byte {}: {} bytes follow the end", size, bytes.size() - size));
  }
  if (container_version > ArchiveWriter::kContainerVersion)
  {
    throw FormatError(fmt::format(
        "archive has layout version {}, this program knows up to {}: use a newer Traverse",
        container_version, ArchiveWriter::kContainerVersion));
  }
}
}  // namespace

ArchiveWriter::ArchiveWriter(std::string kind, uint32_t version) :
    kind_(std::move(kind)), version_(version)
{
  if (kind_.empty() || kind_.size() > kMaxKind)
  {
    throw std::invalid_argument("an archive's kind has 1 to 64 bytes: " + kind_);
  }
}

void ArchiveWriter::section(std::string_view name4, std::string bytes)
{
  const bool known = std::any_of(
      sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name4; });
  if (name4.size() != kNameBytes || known)
  {
    throw std::invalid_argument(
        "an archive's section has a name of 4 bytes of its own: " + std::string(name4));
  }
  sections_.push_back({std::string(name4), std::move(bytes)});
}

std::string ArchiveWriter::finish()
{
  ByteWriter out;
  out.raw(kMagic);
  out.u32(kContainerVersion);
  out.u64(0);  // the size, filled in below
  out.str(kind_);
  out.u32(version_);
  out.u32(static_cast<uint32_t>(sections_.size()));
  for (const Section& s : sections_)
  {
    out.raw(s.name);
    out.u64(s.bytes.size());
    out.u32(crc32(s.bytes));
    out.raw(s.bytes);
  }
  sections_.clear();

  std::string bytes = out.take();
  const uint64_t size = bytes.size() + kCrcBytes;
  std::memcpy(bytes.data() + kSizeAt, &size, sizeof size);
  ByteWriter crc;
  crc.u32(crc32(bytes));
  bytes += crc.bytes();
  return bytes;
}

std::string archiveKind(std::string_view bytes)
{
  checkFrame(bytes);
  ByteReader in(bytes, "archive");
  in.raw(kSizeAt + sizeof(uint64_t));
  return in.str(kMaxKind);
}

ArchiveReader::ArchiveReader(
    std::string_view bytes, std::string_view expected_kind, uint32_t newest_known_version)
{
  checkFrame(bytes);
  if (bytes.size() < kSizeAt + sizeof(uint64_t) + kCrcBytes)
  {
    throw FormatError("archive truncated: shorter than an empty one");
  }
  const std::string_view body = bytes.substr(0, bytes.size() - kCrcBytes);
  const uint32_t crc = ByteReader(bytes.substr(body.size())).u32();

  ByteReader in(body, "archive");
  in.raw(kSizeAt + sizeof(uint64_t));
  kind_ = in.str(kMaxKind);
  version_ = in.u32();
  // Damage is told before kind and version are believed; readSections names the damaged section.
  const bool damaged = crc32(body) != crc;
  if (!damaged && kind_ != expected_kind)
  {
    throw FormatError(
        fmt::format("archive holds a '{}', not a '{}'", shown(kind_), shown(expected_kind)));
  }
  if (!damaged && version_ > newest_known_version)
  {
    throw FormatError(fmt::format(
        "archive of a '{}' has version {}, this program knows up to {}: use a newer Traverse",
        shown(kind_), version_, newest_known_version));
  }
  readSections(in);
  if (damaged)
  {
    throw FormatError("archive damaged: its bytes do not match its CRC-32, in the headers");
  }
}

void ArchiveReader::readSections(ByteReader& in)
{
  const uint32_t sections = in.u32();
  if (sections > in.remaining() / kSectionHeader)
  {
    in.fail(fmt::format("{} sections do not fit in {} bytes", sections, in.remaining()));
  }
  for (uint32_t i = 0; i < sections; ++i)
  {
    Section s;
    s.name = in.raw(kNameBytes);
    const uint64_t length = in.u64();
    const uint32_t crc = in.u32();
    s.first_byte = in.position();
    s.bytes = in.raw(length);
    if (crc32(s.bytes) != crc)
    {
      throw FormatError(fmt::format(
          "archive damaged: section '{}' at byte {} ({} bytes) does not match its CRC-32",
          shown(s.name), s.first_byte, length));
    }
    if (find(s.name) != nullptr)
    {
      in.fail(fmt::format("section '{}' is there twice", shown(s.name)));
    }
    sections_.push_back(s);
  }
  in.expectEnd();
}

const ArchiveReader::Section* ArchiveReader::find(std::string_view name4) const
{
  const auto found = std::find_if(
      sections_.begin(), sections_.end(), [&](const Section& s) { return s.name == name4; });
  return found == sections_.end() ? nullptr : &*found;
}

const ArchiveReader::Section& ArchiveReader::get(std::string_view name4) const
{
  const Section* found = find(name4);
  if (found == nullptr)
  {
    throw FormatError(
        fmt::format("archive of a '{}' has no section '{}'", shown(kind_), shown(name4)));
  }
  return *found;
}

std::string_view ArchiveReader::section(std::string_view name4) const
{
  return get(name4).bytes;
}

ByteReader ArchiveReader::reader(std::string_view name4) const
{
  const Section& s = get(name4);
  return ByteReader(
      s.bytes, fmt::format("archive of a '{}', section '{}'", shown(kind_), shown(name4)),
      s.first_byte);
}

bool ArchiveReader::has(std::string_view name4) const
{
  return find(name4) != nullptr;
}
}  // namespace traverse::formats
