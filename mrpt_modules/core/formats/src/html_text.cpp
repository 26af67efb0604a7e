// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <cmath>
#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/** Length of the well-formed UTF-8 character at the front, 0 where there is none. */
size_t utf8Length(std::string_view text)
{
  const auto byte = [&](size_t i) { return i < text.size() ? uint8_t(text[i]) : uint8_t{0}; };
  const uint8_t first = byte(0);
  const size_t length = first < 0x80U                      ? 1
                        : first >= 0xC2U && first <= 0xDFU ? 2
                        : (first & 0xF0U) == 0xE0U         ? 3
                        : first >= 0xF0U && first <= 0xF4U ? 4
                                                           : 0;
  for (size_t i = 1; i < length; ++i)
  {
    if ((byte(i) & 0xC0U) != 0x80U)
    {
      return 0;
    }
  }
  const bool overlong = (first == 0xE0U && byte(1) < 0xA0U) || (first == 0xF0U && byte(1) < 0x90U);
  const bool beyond = (first == 0xEDU && byte(1) > 0x9FU) || (first == 0xF4U && byte(1) > 0x8FU);
  return overlong || beyond ? 0 : length;
}

std::string_view escapedAscii(char c)
{
  switch (c)
  {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}
}  // namespace

std::string escaped(std::string_view untrusted)
{
  std::string safe;
  while (!untrusted.empty())
  {
    const size_t length = utf8Length(untrusted);
    const char c = untrusted.front();
    const bool control = length == 1 && ((c < ' ' && c != '\n' && c != '\t') || c == '\x7f');
    if (length == 0 || control)
    {
      safe += kReplacement;
      untrusted.remove_prefix(1);
      continue;
    }
    const std::string_view markup = length == 1 ? escapedAscii(c) : std::string_view();
    safe += markup.empty() ? untrusted.substr(0, length) : markup;
    untrusted.remove_prefix(length);
  }
  return safe;
}

std::string base64(std::string_view bytes)
{
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto byte = [&](size_t k)
    { return i + k < bytes.size() ? uint32_t{uint8_t(bytes[i + k])} : 0U; };
    const uint32_t group = (byte(0) << 16U) | (byte(1) << 8U) | byte(2);
    text += kDigits[group >> 18U];
    text += kDigits[(group >> 12U) & 63U];
    text += i + 1 < bytes.size() ? kDigits[(group >> 6U) & 63U] : '=';
    text += i + 2 < bytes.size() ? kDigits[group & 63U] : '=';
  }
  return text;
}

std::string cssColour(layers::Colour colour)
{
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

std::string readableNumber(double value)
{
  constexpr double kMostWhole = 1e15;
  if (!std::isfinite(value) || value != std::floor(value) || std::abs(value) > kMostWhole)
  {
    return fmt::format("{:.4g}", value);
  }
  std::string digits = fmt::format("{:.0f}", std::abs(value));
  for (size_t at = digits.size(); at > 3; at -= 3)
  {
    digits.insert(at - 3, "\xE2\x80\xAF");  // narrow no-break space
  }
  return value < 0 ? "\xE2\x88\x92" + digits : digits;
}
}  // namespace traverse::formats
