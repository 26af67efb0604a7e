// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/map_files.h>
#include <traverse/common_app/why.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <optional>
#include <string_view>

namespace traverse::app
{
namespace
{
std::string why(const std::filesystem::path& folder, const std::array<double, 2>& place_m)
{
  std::string text;
  for (const std::filesystem::path& file : mapFiles(folder))
  {
    const LoadedMap map = loadMap(file);
    text += text.empty() ? "" : "\n";
    text += fmt::format("map: {}, {}\n", file.filename().string(), map.kind);
    for (const layers::Fact& fact : map.consumer->explain(place_m[0], place_m[1]))
    {
      text += fmt::format("{}: {}\n", fact.key, fact.value);
    }
  }
  return text;
}
}  // namespace

std::optional<std::array<double, 2>> placeOf(std::string_view text)
{
  constexpr double kFarthest_m = 1e6;
  const size_t comma = text.find(',');
  if (comma == std::string_view::npos)
  {
    return std::nullopt;
  }
  std::array<double, 2> place{};
  const std::array<std::string_view, 2> parts = {text.substr(0, comma), text.substr(comma + 1)};
  for (size_t i = 0; i < parts.size(); ++i)
  {
    const char* end = parts[i].data() + parts[i].size();
    const auto [stop, error] = std::from_chars(parts[i].data(), end, place[i]);
    if (error != std::errc() || stop != end || !(std::abs(place[i]) <= kFarthest_m))
    {
      return std::nullopt;
    }
  }
  return place;
}

ExitCode printWhy(
    const std::string& program, const std::filesystem::path& folder, const std::string& place)
{
  const auto place_m = placeOf(place);
  if (!place_m)
  {
    fmt::print(
        stderr, "{}: error: --why wants X,Y in metres, e.g. 3.5,-2; not '{}'\n", program, place);
    return ExitCode::usage;
  }
  std::cout << why(folder, *place_m);
  return ExitCode::done;
}
}  // namespace traverse::app
