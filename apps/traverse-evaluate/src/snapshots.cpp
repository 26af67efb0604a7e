// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "snapshots.h"

#include <traverse/common_app/input_file.h>
#include <traverse/common_app/json_text.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
Snapshot snapshotFrom(const Json& json, const std::filesystem::path& run)
{
  const auto name = json.at("file").get<std::string>();
  if (name.empty() || std::filesystem::path(name).filename() != name)
  {
    throw formats::FormatError(fmt::format("names a snapshot '{}' outside its folder", name));
  }
  Snapshot snapshot{json.at("map").get<std::string>(), run / name, json.at("time_s").get<double>()};
  if (!std::isfinite(snapshot.time_s))
  {
    throw formats::FormatError(fmt::format("has no time for '{}'", name));
  }
  return snapshot;
}

std::vector<Snapshot> snapshotsFrom(const std::string& text, const std::filesystem::path& run)
{
  std::vector<Snapshot> all;
  const Json json = parsedMetrics(text);
  if (!json.is_object() || !json.contains("snapshots"))
  {
    return all;
  }
  for (const Json& snapshot : json.at("snapshots"))
  {
    all.push_back(snapshotFrom(snapshot, run));
  }
  std::stable_sort(
      all.begin(), all.end(),
      [](const Snapshot& a, const Snapshot& b) { return a.time_s < b.time_s; });
  return all;
}
}  // namespace

std::vector<Snapshot> snapshotsOf(const std::filesystem::path& run)
{
  constexpr size_t kLargest = size_t{64} << 20U;
  const std::filesystem::path file = run / "metrics.json";
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
  {
    return {};
  }
  const std::string text = asInput([&] { return formats::readFile(file, kLargest); });
  try
  {
    return snapshotsFrom(text, run);
  }
  catch (const Json::exception& e)
  {
    throw formats::FormatError(fmt::format("'{}' is damaged: {}", file.string(), e.what()));
  }
  catch (const formats::FormatError& e)
  {
    throw formats::FormatError(fmt::format("'{}' {}", file.string(), e.what()));
  }
}
}  // namespace traverse::app
