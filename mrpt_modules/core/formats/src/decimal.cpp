// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/decimal.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace traverse::formats
{
namespace
{
constexpr int kNsDigits = 9;
constexpr size_t kMostDigits = 4096;  // longer ones are no times

/** Takes a sign off the front; true for minus. */
bool takeSign(std::string_view& text)
{
  const bool minus = !text.empty() && text.front() == '-';
  if (minus || (!text.empty() && text.front() == '+'))
  {
    text.remove_prefix(1);
  }
  return minus;
}

/** Digits with the decimal point at `point`, counted from their beginning. */
struct Decimal
{
  std::string digits;
  int64_t point = 0;
};

std::optional<Decimal> parseDecimal(std::string_view text)
{
  Decimal decimal;
  const size_t e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  const size_t dot = mantissa.find('.');
  decimal.digits = mantissa.substr(0, dot);
  decimal.point = static_cast<int64_t>(decimal.digits.size());
  if (dot != std::string_view::npos)
  {
    decimal.digits += mantissa.substr(dot + 1);
  }
  if (decimal.digits.empty() || decimal.digits.size() > kMostDigits ||
      decimal.digits.find_first_not_of("0123456789") != std::string::npos)
  {
    return std::nullopt;
  }
  if (e != std::string_view::npos)
  {
    std::string_view exponent = text.substr(e + 1);
    const bool minus = takeSign(exponent);
    uint16_t shift = 0;  // unsigned: no second sign
    const auto [end, error] =
        std::from_chars(exponent.data(), exponent.data() + exponent.size(), shift);
    if (error != std::errc() || end != exponent.data() + exponent.size())
    {
      return std::nullopt;
    }
    decimal.point += minus ? -int64_t{shift} : int64_t{shift};
  }
  return decimal;
}
}  // namespace

std::optional<double> parseNumber(std::string_view text)
{
  if (!text.empty() && text.front() == '+')
  {
    text.remove_prefix(1);
    if (!text.empty() && text.front() == '-')
    {
      return std::nullopt;
    }
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<int64_t> parseSecondsAsNs(std::string_view text)
{
  const bool minus = takeSign(text);
  const std::optional<Decimal> decimal = parseDecimal(text);
  if (!decimal)
  {
    return std::nullopt;
  }
  const auto digit = [&](int64_t i)
  {
    const bool inside = i >= 0 && i < static_cast<int64_t>(decimal->digits.size());
    return inside ? decimal->digits[static_cast<size_t>(i)] - '0' : 0;
  };
  constexpr int64_t kMost = std::numeric_limits<int64_t>::max() - 1;  // room to round up
  const int64_t end = decimal->point + kNsDigits;
  int64_t ns = 0;
  for (int64_t i = 0; i < end; ++i)
  {
    const int64_t next = digit(i);
    if (ns > (kMost - next) / 10)
    {
      return std::nullopt;
    }
    ns = 10 * ns + next;
  }
  ns += static_cast<int64_t>(digit(end) >= 5);
  return minus ? -ns : ns;
}
}  // namespace traverse::formats
