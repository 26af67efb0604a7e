// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/cloud_file.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
enum class NumberKind : uint8_t
{
  floating,
  signed_integer,
  unsigned_integer,
};

/** One number per point in a table of bytes. */
struct CloudField
{
  std::string name;  //!< lower case
  NumberKind kind = NumberKind::floating;
  size_t size = 4;    //!< bytes: 1, 2, 4, 8; floating 4 or 8
  size_t offset = 0;  //!< of the first point's
  size_t step = 0;    //!< from one point to the next
};

/** Points as binary numbers, whatever file they came from. */
struct CloudTable
{
  std::string storage;     //!< where bytes are not the file's own
  std::string_view bytes;  //!< holds every field of every point: checked by who makes it
  bool big_endian = false;
  size_t points = 0;
  std::vector<CloudField> fields;

  /** Any bits. */
  double number(const CloudField& field, size_t point) const;

  /** Exact for 64-bit integers; 0 for what does not fit. */
  int64_t integer(const CloudField& field, size_t point) const;

  /** Bits of a number of 4 bytes. */
  uint32_t bits(const CloudField& field, size_t point) const;
};

/** A field's type by the letter and size that PCD writes; throws FormatError. */
void setType(CloudField& field, char letter, size_t size);

/** Lays fields out one behind the other; returns the bytes of a point. */
size_t layOut(std::vector<CloudField>& fields);

/** Appends a number of a text in the field's type; "nan" and what does not fit is NaN or 0. Throws
 * FormatError for what is no number. */
void appendText(std::string& bytes, const CloudField& field, std::string_view text);

/** The fields that are known, as a cloud. Throws FormatError where x, y or z is missing. */
CloudFile cloudOf(const CloudTable& table);

/** Fills time_s, stamp_ns and note from a field of times. */
void takeTimes(const CloudTable& table, const CloudField& field, CloudFile& cloud);
}  // namespace traverse::formats
