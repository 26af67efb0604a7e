// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/options/option.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace traverse::options
{
namespace
{
template <class N>
N parseNumber(const Option& option, std::string_view text)
{
  N number{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool whole = error == std::errc{} && stop == end && !text.empty();
  if (!whole || !std::isfinite(static_cast<double>(number)))
  {
    throw OptionError(option.key, text, rangeText(option));
  }
  check(option, static_cast<double>(number));
  return number;
}
}  // namespace

OptionError::OptionError(std::string_view key, std::string_view value, std::string_view allowed) :
    std::runtime_error(fmt::format("{} = '{}' is not allowed; allowed: {}", key, value, allowed))
{
}

std::string rangeText(const Option& option)
{
  const auto [min, max] = option.range;
  if (std::isinf(min) && std::isinf(max))
  {
    return "any number";
  }
  if (std::isinf(max))
  {
    return fmt::format(">= {}", min);
  }
  return std::isinf(min) ? fmt::format("<= {}", max) : fmt::format("{} to {}", min, max);
}

void check(const Option& option, double value)
{
  const bool inside = value >= option.range.min && value <= option.range.max;
  if (!inside)
  {
    throw OptionError(option.key, format(value), rangeText(option));
  }
}

void parse(const Option& option, std::string_view text, bool& value)
{
  if (text == "true" || text == "1" || text == "yes")
  {
    value = true;
  }
  else if (text == "false" || text == "0" || text == "no")
  {
    value = false;
  }
  else
  {
    throw OptionError(option.key, text, "true | false");
  }
}

void parse(const Option& option, std::string_view text, int& value)
{
  value = parseNumber<int>(option, text);
}

void parse(const Option& option, std::string_view text, double& value)
{
  value = parseNumber<double>(option, text);
}

void parse(const Option& /*option*/, std::string_view text, std::string& value)
{
  value = std::string(text);
}

void parse(const Option& option, std::string_view text, std::vector<double>& value)
{
  std::vector<double> all;
  for (size_t i = text.find_first_not_of(" \t"); i != std::string_view::npos;)
  {
    const size_t end = std::min(text.find_first_of(" \t", i), text.size());
    all.push_back(parseNumber<double>(option, text.substr(i, end - i)));
    i = text.find_first_not_of(" \t", end);
  }
  value = std::move(all);
}

std::string format(bool value)
{
  return value ? "true" : "false";
}

std::string format(int value)
{
  return std::to_string(value);
}

std::string format(double value)
{
  return fmt::format("{}", value);
}

std::string format(const std::string& value)
{
  return value;
}

std::string format(const std::vector<double>& value)
{
  return fmt::format("{}", fmt::join(value, " "));
}

namespace
{
size_t editDistance(std::string_view a, std::string_view b)
{
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i)
  {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j)
    {
      const size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row.back();
}
}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& known)
{
  std::string best;
  size_t best_distance = std::max<size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : known)
  {
    const size_t distance = editDistance(word, candidate);
    if (distance < best_distance)
    {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}
}  // namespace traverse::options
