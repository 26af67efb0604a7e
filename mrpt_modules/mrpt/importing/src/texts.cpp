// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folders.h"

#include <traverse/formats/bytes.h>
#include <traverse/formats/decimal.h>
#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>

#include <algorithm>
#include <charconv>
#include <chrono>

namespace traverse::importing
{
namespace
{
constexpr size_t kLargestText = 1U << 28U;
constexpr std::string_view kBlanks = " \t\r\n";

/** Takes the next word off a text; empty at its end. */
std::string_view takeWord(std::string_view& text)
{
  const size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  text.remove_prefix(begin);
  const std::string_view word = text.substr(0, std::min(text.find_first_of(kBlanks), text.size()));
  text.remove_prefix(word.size());
  return word;
}

std::string_view takeLine(std::string_view& text)
{
  const size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

/** Digits and the mark behind them; nothing where it is not so. */
std::optional<int> takeNumber(std::string_view& text, size_t digits, char mark)
{
  int value = 0;
  const std::string_view number = text.substr(0, digits);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  const bool whole = error == std::errc() && end == number.data() + digits && value >= 0;
  const bool marked = mark == 0 || (text.size() > digits && text[digits] == mark);
  if (number.size() != digits || !whole || !marked)
  {
    return std::nullopt;
  }
  text.remove_prefix(digits + (mark == 0 ? 0 : 1));
  return value;
}

bool isClock(poses::TimeNs time)
{
  constexpr poses::TimeNs k1980 = 315'532'800'000'000'000;
  constexpr poses::TimeNs k2100 = 4'102'444'800'000'000'000;
  return time >= k1980 && time < k2100;
}
}  // namespace

std::string textOf(const std::filesystem::path& file)
{
  std::string bytes = formats::readFile(file, kLargestText);
  return formats::isGzip(bytes) ? formats::gunzip(bytes, kLargestText) : bytes;
}

std::optional<poses::TimeNs> parseCivilTime(std::string_view text)
{
  namespace chr = std::chrono;
  const auto year = takeNumber(text, 4, '-');
  const auto month = year ? takeNumber(text, 2, '-') : std::nullopt;
  const auto day = month ? takeNumber(text, 2, ' ') : std::nullopt;
  const auto hour = day ? takeNumber(text, 2, ':') : std::nullopt;
  const auto minute = hour ? takeNumber(text, 2, ':') : std::nullopt;
  const auto seconds = minute ? formats::parseSecondsAsNs(text) : std::nullopt;
  if (!seconds || *seconds < 0 || *seconds > 61'000'000'000 || *hour > 23 || *minute > 59)
  {
    return std::nullopt;
  }
  const chr::year_month_day date(
      chr::year(*year), chr::month(static_cast<unsigned>(*month)),
      chr::day(static_cast<unsigned>(*day)));
  if (!date.ok() || *year < 1980 || *year >= 2100)
  {
    return std::nullopt;
  }
  const auto days = chr::sys_days(date).time_since_epoch();
  return chr::nanoseconds(days + chr::hours(*hour) + chr::minutes(*minute)).count() + *seconds;
}

std::optional<poses::TimeNs> stampInName(const std::string& stem)
{
  constexpr std::string_view kDigits = "0123456789.";
  // The last run of digits: "cloud_1600000000.25", "1600000000250000000_up".
  size_t end = stem.find_last_of("0123456789");
  while (end != std::string::npos)
  {
    const size_t before = stem.find_last_not_of(kDigits, end);
    const size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::string number = stem.substr(begin, end + 1 - begin);
    const size_t whole = std::min(number.find('.'), number.size());
    if (whole >= 9 && whole <= 19)
    {
      const size_t unit = (std::min<size_t>(whole, 19) - 9) / 3;  // s, ms, us, ns
      const auto value = formats::parseSecondsAsNs(
          number.substr(0, whole - unit * 3) + "." + number.substr(whole - unit * 3, unit * 3) +
          (whole < number.size() && unit == 0 ? number.substr(whole + 1) : "0"));
      if (value && isClock(*value))
      {
        return value;
      }
    }
    end = begin == 0 ? std::string::npos : stem.find_last_of("0123456789", begin - 1);
  }
  return std::nullopt;
}

std::vector<std::optional<poses::TimeNs>> civilTimesOf(const std::filesystem::path& file)
{
  const std::string text = textOf(file);
  std::string_view rest = text;
  std::vector<std::optional<poses::TimeNs>> times;
  while (!rest.empty())
  {
    std::string_view line = takeLine(rest);
    const size_t end = line.find_last_not_of(kBlanks);
    times.push_back(parseCivilTime(line.substr(0, end == std::string::npos ? 0 : end + 1)));
  }
  return times;
}

std::vector<double> numbersOf(std::string_view text)
{
  std::vector<double> numbers;
  for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
  {
    const auto number = formats::parseNumber(word);
    if (!number)
    {
      throw formats::FormatError("has a value that is no number");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

NamedNumbers namedNumbersOf(const std::filesystem::path& file)
{
  const std::string text = textOf(file);
  std::string_view rest = text;
  NamedNumbers named;
  while (!rest.empty())
  {
    const std::string_view line = takeLine(rest);
    const size_t colon = line.find(':');
    if (colon == std::string_view::npos)
    {
      continue;
    }
    try
    {
      named[std::string(line.substr(0, colon))] = numbersOf(line.substr(colon + 1));
    }
    catch (const formats::FormatError&)
    {
      continue;  // calib_time and the like
    }
  }
  return named;
}
}  // namespace traverse::importing
