// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "index_runs.h"

#include "metrics_json.h"

#include <traverse/formats/run_index.h>
#include <traverse/formats/safe_file.h>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <vector>

namespace traverse::app
{
namespace
{
namespace fs = std::filesystem;
constexpr size_t kMostRuns = 2000;
constexpr size_t kMostThumbnails = 500;  // of 10 to 20 kB each

bool isThere(const fs::path& file)
{
  std::error_code error;
  return fs::is_regular_file(file, error);
}

/** Folders that a run made or began, by name. */
std::vector<fs::path> runsIn(const fs::path& folder)
{
  std::vector<fs::path> runs;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
  {
    std::error_code unreadable;
    const fs::path path = it->path();
    if (fs::is_directory(path, unreadable) &&
        (path.extension() == ".partial" || isThere(path / "metrics.json") ||
         isThere(path / "report.html")))
    {
      runs.push_back(path);
    }
  }
  if (error)
  {
    throw formats::FormatError(
        fmt::format("cannot read folder '{}': {}", folder.string(), error.message()));
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

/** A member that must be of a type; anything else says the file is damaged. */
const Json& member(const Json& json, const char* key, bool (Json::*is_type)() const noexcept)
{
  const auto found = json.is_object() ? json.find(key) : json.end();
  if (!json.is_object() || found == json.end() || !((*found).*is_type)())
  {
    throw formats::FormatError(fmt::format("is damaged: no proper '{}'", key));
  }
  return *found;
}

std::string stateOf(const Json& json)
{
  const Json& problems = member(json, "problems", &Json::is_array);
  if (member(json, "complete", &Json::is_boolean).get<bool>())
  {
    return "complete";
  }
  const bool said = !problems.empty() && problems.front().is_string();
  return "partial: " +
         (said ? problems.front().get<std::string>() : std::string("no reason given"));
}

/** What metrics.json says, all of it or an exception. */
void readMetrics(const Json& json, formats::RunEntry& run)
{
  formats::RunEntry read = run;
  read.state = stateOf(json);
  read.good = read.state == "complete";
  read.log = fs::path(member(json, "rawlog", &Json::is_string).get<std::string>()).filename();
  read.scans = member(json, "scans", &Json::is_number_unsigned).get<uint64_t>();
  read.points = member(json, "points", &Json::is_number_unsigned).get<uint64_t>();
  read.seconds = member(json, "seconds_total", &Json::is_number).get<double>();
  read.recorded_s = member(json, "first_stamp_s", &Json::is_number).get<double>();
  read.warnings = member(json, "warnings", &Json::is_array).size();
  if (json.contains("title"))
  {
    read.title = member(json, "title", &Json::is_string).get<std::string>();
  }
  run = std::move(read);
}

/** The first map's picture from above. */
std::string pictureOf(const fs::path& folder)
{
  constexpr size_t kLargest = size_t{32} << 20U;
  constexpr int kWidth_px = 150;
  try
  {
    return formats::thumbnail(formats::readFile(folder / "map_top.png", kLargest), kWidth_px)
        .value_or("");
  }
  catch (const formats::FileError&)
  {
    return "";
  }
}

formats::RunEntry entryOf(const fs::path& folder, bool with_picture)
{
  constexpr size_t kLargestMetrics = size_t{1} << 20U;
  formats::RunEntry run;
  run.folder = folder.filename().string();
  run.has_report = isThere(folder / "report.html");
  run.thumbnail = with_picture ? pictureOf(folder) : "";
  if (folder.extension() == ".partial")
  {
    run.state = "not finished: a run is writing it, or was ended";
    return run;
  }
  try
  {
    readMetrics(parsedMetrics(formats::readFile(folder / "metrics.json", kLargestMetrics)), run);
  }
  catch (const Json::exception&)
  {
    run.state = "metrics.json is damaged: no JSON";
  }
  catch (const formats::FormatError& e)
  {
    run.state = std::string("metrics.json ") + e.what();
  }
  catch (const formats::FileError&)
  {
    run.state = isThere(folder / "metrics.json") ? "metrics.json cannot be read, or is far too long"
                                                 : "not finished: metrics.json is missing";
  }
  return run;
}

void checkReplaceable(const fs::path& file, bool force)
{
  std::error_code error;
  if (force || !fs::exists(fs::symlink_status(file, error)))
  {
    return;
  }
  std::string start(formats::runIndexMark().size(), ' ');
  if (isThere(file))
  {
    std::ifstream(file, std::ios::binary)
        .read(start.data(), static_cast<std::streamsize>(start.size()));
  }
  if (start != formats::runIndexMark())
  {
    throw formats::FileError(file, "is there and is no index of runs; --force replaces it");
  }
}
}  // namespace

fs::path writeIndex(const fs::path& folder, bool force)
{
  std::vector<fs::path> paths = runsIn(folder);
  fs::path file = folder / "index.html";
  checkReplaceable(file, force);
  std::string note;
  if (paths.size() > kMostRuns)
  {
    note = fmt::format("{} folders more are not shown.", paths.size() - kMostRuns);
    paths.resize(kMostRuns);
  }
  std::vector<formats::RunEntry> runs;
  runs.reserve(paths.size());
  for (const fs::path& path : paths)
  {
    runs.push_back(entryOf(path, runs.size() < kMostThumbnails));
  }
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  formats::writeFile(file, formats::runIndex("Runs in " + whole.filename().string(), runs, note));
  return file;
}
}  // namespace traverse::app
