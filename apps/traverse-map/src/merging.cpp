// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "merging.h"

#include "mapping.h"
#include "outputs.h"
#include "piece.h"
#include "settings.h"
#include "verdict.h"

#include <traverse/common_app/input_file.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/map_set.h>
#include <traverse/common_app/progress.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
namespace fs = std::filesystem;
using formats::FormatError;

/** The output folder of a piece. */
struct PieceFolder
{
  fs::path path;
  RunMetrics metrics;

  const PieceMetrics& piece() const { return *metrics.piece; }
};

std::string readInput(const fs::path& file)
{
  constexpr size_t kLargest = size_t{1} << 40U;
  return asInput([&] { return formats::readFile(file, kLargest); });
}

PieceFolder readFolder(const fs::path& given)
{
  const fs::path path = given.has_filename() ? given : given.parent_path();
  const fs::path file = path / formats::OutputFolder::kLastFile;
  if (path.extension() == ".partial" || !fs::exists(file))
  {
    throw FormatError(fmt::format(
        "'{}' is no complete output of traverse-map: {}", path.string(),
        path.extension() == ".partial" ? "its run did not end" : "it has no metrics.json"));
  }
  PieceFolder folder{path, {}};
  try
  {
    folder.metrics = pieceFromJson(readInput(file));
  }
  catch (const FormatError& e)
  {
    throw FormatError(fmt::format("'{}' {}", file.string(), e.what()));
  }
  if (!folder.piece().whole)
  {
    throw FormatError(fmt::format(
        "'{}': piece {} of {} was not mapped to its end; run it again", path.string(),
        folder.piece().number, folder.piece().of));
  }
  return folder;
}

void checkSameLog(const PieceFolder& a, const PieceFolder& b)
{
  const auto differ = [&](const char* what)
  { return FormatError(fmt::format("'{}' and '{}' {}", a.path.string(), b.path.string(), what)); };
  const PieceMetrics& p = a.piece();
  const PieceMetrics& q = b.piece();
  if (p.log_bytes != q.log_bytes || p.log_crc32 != q.log_crc32 || p.log_entries != q.log_entries)
  {
    throw differ("are pieces of different logs");
  }
  if (p.of != q.of)
  {
    throw differ("are pieces of different numbers of pieces");
  }
  if (p.poses_crc32 != q.poses_crc32)
  {
    throw differ("were mapped with different poses");
  }
}

/** Every piece once; sorts them. */
void checkAllThere(std::vector<PieceFolder>& folders)
{
  std::sort(
      folders.begin(), folders.end(),
      [](const PieceFolder& a, const PieceFolder& b)
      { return a.piece().number < b.piece().number; });
  for (size_t i = 0; i < folders.size(); ++i)
  {
    checkSameLog(folders.front(), folders[i]);
    if (i > 0 && folders[i].piece().number == folders[i - 1].piece().number)
    {
      throw FormatError(fmt::format(
          "piece {} is there twice: '{}' and '{}'", folders[i].piece().number,
          folders[i - 1].path.string(), folders[i].path.string()));
    }
  }
  const uint64_t of = folders.front().piece().of;
  for (uint64_t number = 1; number <= of; ++number)
  {
    if (number > folders.size() || folders[number - 1].piece().number != number)
    {
      throw FormatError(fmt::format("piece {} of {} is missing", number, of));
    }
  }
}

Settings settingsOf(const PieceFolder& folder, const Command& command)
{
  const fs::path file = folder.path / kConfigFile;
  if (!fs::exists(file))
  {
    throw FormatError(fmt::format("'{}' is missing", file.string()));
  }
  Command as_there;
  as_there.config = file;
  as_there.output = command.output;
  as_there.force = command.force;
  as_there.quiet = command.quiet;
  return loadSettings(as_there);
}

void checkSameRecipe(
    const PieceFolder& a, const Settings& of_a, const PieceFolder& b, const Settings& of_b)
{
  const auto first = recipe(of_a);
  const auto other = recipe(of_b);
  const auto [p, q] = std::mismatch(first.begin(), first.end(), other.begin(), other.end());
  if (p != first.end() || q != other.end())
  {
    const auto text = [](const auto& entry, const auto& end)
    { return entry == end ? std::string("nothing") : entry->first + " = " + entry->second; };
    throw config::ConfigError(fmt::format(
        "'{}' and '{}' were mapped with different options: {} and {}", a.path.string(),
        b.path.string(), text(p, first.end()), text(q, other.end())));
  }
}

void mergeMap(const PieceFolder& folder, BuiltMap& map)
{
  fs::path file = folder.path / archiveName(map);
  try
  {
    map.consumer->mergeArchive(readInput(file));
    file.replace_extension(map.consumer->mergedEnding());
    if (file.has_extension() && fs::exists(file))  // a piece without points has none
    {
      map.consumer->mergeExtra(readInput(file));
    }
  }
  catch (const FormatError& e)
  {
    throw FormatError(fmt::format("'{}': {}", file.string(), e.what()));
  }
  catch (const std::invalid_argument& e)
  {
    throw config::ConfigError(fmt::format("'{}': {}", file.string(), e.what()));
  }
  catch (const std::length_error& e)
  {
    throw config::ConfigError(
        fmt::format("'{}': {}; map the pieces again with more", file.string(), e.what()));
  }
}

void refuseLostPoints(const PieceFolder& folder)
{
  for (const MapMetrics& map : folder.metrics.maps)
  {
    if (map.over_budget > 0)
    {
      throw config::ConfigError(fmt::format(
          "'{}': {} points of {} found no room; map the pieces again with more max_memory_mb",
          folder.path.string(), map.over_budget, map.name));
    }
  }
}

/** All pieces in order, of one log. */
std::vector<PieceFolder> readFolders(const Command& command)
{
  std::vector<PieceFolder> folders;
  for (const fs::path& path : command.merge)
  {
    folders.push_back(readFolder(path));
  }
  checkAllThere(folders);
  return folders;
}

/** The settings of all pieces, which are the same. */
Settings commonSettings(const std::vector<PieceFolder>& folders, const Command& command)
{
  Settings first = settingsOf(folders.front(), command);
  for (const PieceFolder& folder : folders)
  {
    refuseLostPoints(folder);
    checkSameRecipe(folders.front(), first, folder, settingsOf(folder, command));
  }
  return first;
}

void mergeMaps(
    const std::vector<PieceFolder>& folders,
    const Settings& settings,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics)
{
  listMaps(maps, metrics);
  Progress progress("merging", "pieces", settings.quiet);
  for (const PieceFolder& folder : folders)
  {
    if (Interrupt::exitCode())
    {
      return;
    }
    for (BuiltMap& map : maps)
    {
      metrics.times.during("merge", [&] { mergeMap(folder, map); });
    }
    addPiece(metrics, folder.metrics);
    progress.show(
        static_cast<double>(metrics.merged_pieces) / static_cast<double>(folders.size()),
        metrics.merged_pieces);
  }
  progress.finish(metrics.merged_pieces);
}
}  // namespace

std::filesystem::path mergeFolders(const Command& command, RunMetrics& metrics)
{
  const std::vector<PieceFolder> folders = readFolders(command);
  const Settings settings = commonSettings(folders, command);
  std::vector<BuiltMap> maps = buildMaps(settings.ini, settings.maps);
  checkPieces(settings, maps);
  Outputs outputs(settings, metrics);
  mergeMaps(folders, settings, maps, metrics);
  if (Interrupt::exitCode())
  {
    metrics.problems.emplace_back("interrupted: nothing was written");
    return {};
  }
  metrics.complete = metrics.problems.empty();
  noteWhatIsMissing(metrics);
  if (metrics.scans == 0)
  {
    return {};
  }
  outputs.finish(maps, poses::PoseTrack(), 0);
  return outputs.folder();
}
}  // namespace traverse::app
