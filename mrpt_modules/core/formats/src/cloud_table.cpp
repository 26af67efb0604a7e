// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_table.h"

#include <traverse/formats/bytes.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <initializer_list>
#include <limits>

namespace traverse::formats
{
namespace
{
template <class T>
T take(const CloudTable& table, const CloudField& field, size_t point)
{
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), table.bytes.data() + field.offset + point * field.step, sizeof(T));
  if (table.big_endian)
  {
    std::reverse(raw.begin(), raw.end());
  }
  T value;
  std::memcpy(&value, raw.data(), sizeof(T));
  return value;
}

/** Calls f with the number in its own type. */
template <class F>
auto visitNumber(const CloudTable& table, const CloudField& field, size_t point, F&& f)
{
  const bool has_sign = field.kind == NumberKind::signed_integer;
  if (field.kind == NumberKind::floating)
  {
    return field.size == 8 ? f(take<double>(table, field, point))
                           : f(take<float>(table, field, point));
  }
  switch (field.size)
  {
    case 1:
      return has_sign ? f(take<int8_t>(table, field, point))
                      : f(take<uint8_t>(table, field, point));
    case 2:
      return has_sign ? f(take<int16_t>(table, field, point))
                      : f(take<uint16_t>(table, field, point));
    case 4:
      return has_sign ? f(take<int32_t>(table, field, point))
                      : f(take<uint32_t>(table, field, point));
    default:
      return has_sign ? f(take<int64_t>(table, field, point))
                      : f(take<uint64_t>(table, field, point));
  }
}

template <class T>
void append(std::string& bytes, T value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

template <class T>
void appendInteger(std::string& bytes, double value)
{
  constexpr double kPast = 2.0 * static_cast<double>(T{1} << (std::numeric_limits<T>::digits - 1));
  const bool fits = value >= static_cast<double>(std::numeric_limits<T>::min()) && value < kPast;
  append(bytes, fits ? static_cast<T>(value) : T{0});
}

template <class Signed, class Unsigned>
void appendEither(std::string& bytes, NumberKind kind, double value)
{
  if (kind == NumberKind::signed_integer)
  {
    appendInteger<Signed>(bytes, value);
  }
  else
  {
    appendInteger<Unsigned>(bytes, value);
  }
}

double parseAny(std::string_view text)
{
  const std::string_view body =
      !text.empty() && (text[0] == '-' || text[0] == '+') ? text.substr(1) : text;
  if (!body.empty() && (body[0] == 'n' || body[0] == 'N' || body[0] == 'i' || body[0] == 'I'))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::string_view number = !text.empty() && text[0] == '+' ? body : text;
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size())
  {
    throw FormatError("a value that is no number");
  }
  return value;
}
}  // namespace

double CloudTable::number(const CloudField& field, size_t point) const
{
  return visitNumber(*this, field, point, [](auto v) { return static_cast<double>(v); });
}

int64_t CloudTable::integer(const CloudField& field, size_t point) const
{
  return visitNumber(
      *this, field, point,
      [](auto v) -> int64_t
      {
        if constexpr (std::is_floating_point_v<decltype(v)>)
        {
          return std::abs(v) < 9e18 ? static_cast<int64_t>(v) : 0;
        }
        else if constexpr (std::is_same_v<decltype(v), uint64_t>)
        {
          return v <= uint64_t{std::numeric_limits<int64_t>::max()} ? static_cast<int64_t>(v) : 0;
        }
        else
        {
          return v;
        }
      });
}

uint32_t CloudTable::bits(const CloudField& field, size_t point) const
{
  return take<uint32_t>(*this, field, point);
}

void setType(CloudField& field, char letter, size_t size)
{
  const bool floating = letter == 'F' && (size == 4 || size == 8);
  const bool integer =
      (letter == 'I' || letter == 'U') && (size == 1 || size == 2 || size == 4 || size == 8);
  if (!floating && !integer)
  {
    throw FormatError("a field of an unknown type");
  }
  field.size = size;
  field.kind = floating        ? NumberKind::floating
               : letter == 'I' ? NumberKind::signed_integer
                               : NumberKind::unsigned_integer;
}

size_t layOut(std::vector<CloudField>& fields)
{
  size_t stride = 0;
  for (CloudField& field : fields)
  {
    field.offset = stride;
    stride += field.size;
  }
  for (CloudField& field : fields)
  {
    field.step = stride;
  }
  return stride;
}

void appendText(std::string& bytes, const CloudField& field, std::string_view text)
{
  if (field.size == 8 && field.kind != NumberKind::floating)
  {
    int64_t exact = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exact);
    if (error == std::errc() && end == text.data() + text.size())
    {
      append(bytes, exact);
      return;
    }
  }
  const double value = parseAny(text);
  if (field.kind == NumberKind::floating)
  {
    field.size == 8 ? append(bytes, value) : append(bytes, static_cast<float>(value));
    return;
  }
  switch (field.size)
  {
    case 1:
      return appendEither<int8_t, uint8_t>(bytes, field.kind, value);
    case 2:
      return appendEither<int16_t, uint16_t>(bytes, field.kind, value);
    case 4:
      return appendEither<int32_t, uint32_t>(bytes, field.kind, value);
    default:
      return appendEither<int64_t, uint64_t>(bytes, field.kind, value);
  }
}
}  // namespace traverse::formats
