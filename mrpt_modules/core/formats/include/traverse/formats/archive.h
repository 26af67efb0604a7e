// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/bytes.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** Collects named sections into one checked byte string: the same sections give the same bytes.
 *
 * Layout, little-endian:
 *
 *     8   magic 89 54 52 41 56 0D 0A 1A    (\x89 "TRAV" \r \n \x1a: text-mode copies show at once)
 *     u32 version of this layout           (kContainerVersion)
 *     u64 size of the whole, in bytes      (so that a truncated file is told from a damaged one)
 *     str kind                             (u32 length, bytes: "traversability_grid")
 *     u32 version of the contents          (the kind's own)
 *     u32 number of sections
 *     each section: 4 bytes name, u64 length, u32 CRC-32 of its bytes, its bytes
 *     u32 CRC-32 of all before it
 *
 * Magic, layout version, size, kind, content version and the last CRC stay where they are in all
 * layout versions to come. */
class ArchiveWriter
{
 public:
  static constexpr uint32_t kContainerVersion = 1;

  /** `kind` says what is inside (at most 64 bytes), `version` is its content's. */
  ArchiveWriter(std::string kind, uint32_t version);

  /** `name4` has 4 bytes and is new; otherwise std::invalid_argument. */
  void section(std::string_view name4, std::string bytes);

  /** The archive; the writer is empty afterwards. */
  std::string finish();

 private:
  struct Section
  {
    std::string name;
    std::string bytes;
  };

  std::string kind_;
  uint32_t version_;
  std::vector<Section> sections_;
};

/** The kind of an archive, by which a reader for it is found: only that much is looked at. Throws
 * FormatError for bytes that are no archive, or not as many as it says. */
std::string archiveKind(std::string_view bytes);

/** Checks and takes apart what ArchiveWriter made. Looks into the caller's bytes: they must outlive
 * it, and so the section views. */
class ArchiveReader
{
 public:
  /** Throws FormatError that says what is wrong and where: not an archive, truncated, damaged (and
   * in which section), of another kind, newer than newest_known_version (naming both). */
  ArchiveReader(
      std::string_view bytes, std::string_view expected_kind, uint32_t newest_known_version);

  /** Throws FormatError where there is none of that name. */
  std::string_view section(std::string_view name4) const;

  /** A reader on section(name4) whose messages name the kind, the section and the byte. */
  ByteReader reader(std::string_view name4) const;

  bool has(std::string_view name4) const;

  /** Of the contents. */
  uint32_t version() const { return version_; }

 private:
  struct Section
  {
    std::string_view name;
    std::string_view bytes;
    size_t first_byte = 0;
  };

  const Section* find(std::string_view name4) const;
  const Section& get(std::string_view name4) const;
  void readSections(ByteReader& in);

  std::string kind_;
  uint32_t version_ = 0;
  std::vector<Section> sections_;
};
}  // namespace traverse::formats
