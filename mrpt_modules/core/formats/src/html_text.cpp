// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "html_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace traverse::formats
{
namespace
{
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/** What may follow the first byte of a UTF-8 character (RFC 3629, table of section 4). */
struct Utf8Form
{
  uint8_t first_low, first_high;
  uint8_t second_low, second_high;
  size_t length;
};

constexpr std::array<Utf8Form, 9> kUtf8Forms = {
    {{0x00, 0x7F, 0x00, 0x00, 1},
     {0xC2, 0xDF, 0x80, 0xBF, 2},
     {0xE0, 0xE0, 0xA0, 0xBF, 3},
     {0xE1, 0xEC, 0x80, 0xBF, 3},
     {0xED, 0xED, 0x80, 0x9F, 3},
     {0xEE, 0xEF, 0x80, 0xBF, 3},
     {0xF0, 0xF0, 0x90, 0xBF, 4},
     {0xF1, 0xF3, 0x80, 0xBF, 4},
     {0xF4, 0xF4, 0x80, 0x8F, 4}}};

bool fits(const Utf8Form& form, std::string_view text)
{
  const auto within = [&](size_t i, uint8_t low, uint8_t high)
  { return uint8_t(text[i]) >= low && uint8_t(text[i]) <= high; };
  bool good = text.size() >= form.length && within(0, form.first_low, form.first_high) &&
              (form.length == 1 || within(1, form.second_low, form.second_high));
  for (size_t i = 2; good && i < form.length; ++i)
  {
    good = within(i, 0x80, 0xBF);
  }
  return good;
}

/** Length of the well-formed UTF-8 character at the front, 0 where there is none. */
size_t utf8Length(std::string_view text)
{
  const auto form = std::find_if(
      kUtf8Forms.begin(), kUtf8Forms.end(), [&](const Utf8Form& f) { return fits(f, text); });
  return form == kUtf8Forms.end() ? 0 : form->length;
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

std::string jsonInPage(std::string_view ascii_json)
{
  std::string safe;
  safe.reserve(ascii_json.size());
  for (const char c : ascii_json)
  {
    if (c == '<' || c == '>' || c == '&')  // in JSON they stand inside strings only
    {
      safe += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    }
    else
    {
      safe += c;
    }
  }
  return safe;
}

std::string PageScript::source() const
{
  constexpr int kHexadecimal = 16;
  std::string digest;
  for (size_t i = 0; i + 1 < sha256_hex.size(); i += 2)
  {
    digest +=
        static_cast<char>(std::stoi(std::string(sha256_hex.substr(i, 2)), nullptr, kHexadecimal));
  }
  return "'sha256-" + base64(digest) + "'";
}

std::string shortened(const std::string& text, size_t most)
{
  size_t characters = 0;
  for (size_t i = 0; i < text.size(); ++i)
  {
    const bool begins = (static_cast<uint8_t>(text[i]) & 0xC0U) != 0x80U;
    if (begins && ++characters > most)
    {
      return text.substr(0, i) + "\xE2\x80\xA6";
    }
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
