// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "index_runs.h"
#include "label_files.h"
#include "mapping.h"
#include "merging.h"
#include "outputs.h"
#include "piece.h"
#include "rebuild.h"
#include "settings.h"
#include "track.h"
#include "verdict.h"

#include <traverse/common_app/failures.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/map_set.h>
#include <traverse/common_app/why.h>
#include <traverse/formats/archive.h>
#include <traverse/formats/safe_file.h>
#include <traverse/logs/log_reader.h>
#include <traverse/map_app/app.h>
#include <traverse/plugin/register.h>

#include <fmt/format.h>
#include <iostream>

namespace traverse::app
{
namespace
{
void tell(const std::string& kind, const std::vector<std::string>& messages)
{
  for (const std::string& message : messages)
  {
    fmt::print(stderr, "traverse-map: {}: {}\n", kind, message);
  }
}

/** Says where the results are (`folder` is empty where there are none) and what to know of them. */
ExitCode concluded(const RunMetrics& metrics, const std::filesystem::path& folder)
{
  if (!folder.empty())
  {
    std::cout << (folder / "report.html").string() << "\n";
  }
  tell("warning", metrics.warnings);
  tell("problem", metrics.problems);
  return verdict(metrics);
}

std::vector<BuiltMap> buildChecked(const Settings& settings)
{
  std::vector<BuiltMap> maps = buildMaps(settings.ini, settings.maps);
  if (settings.piece)
  {
    checkPieces(settings, maps);
  }
  return maps;
}

ExitCode mapIt(const Settings& settings)
{
  RunMetrics metrics;
  metrics.rawlog = settings.rawlog.string();
  metrics.warnings = settings.warnings;
  const Interrupt interrupt;
  std::vector<BuiltMap> maps = buildChecked(settings);
  Outputs outputs(settings, metrics);
  std::optional<LabelFiles> labels;
  if (!settings.point_labels.empty())
  {
    labels.emplace(settings.point_labels, settings.force);
  }
  const poses::PoseTrack track = metrics.times.during(
      "poses", [&] { return makeTrack(settings, metrics, Interrupt::flag()); });
  if (settings.piece)
  {
    metrics.piece =
        metrics.times.during("count", [&] { return describePiece(settings, track, metrics); });
  }
  poses::TimeNs last_stamp = 0;
  mapLog(
      settings, track, maps, metrics,
      [&](const points::Decoded& decoded)
      {
        last_stamp = decoded.scan.stamp;
        if (labels)
        {
          labels->write(decoded, track, maps);
        }
        outputs.snapshot(maps, track, last_stamp);
      });
  noteAbsentLabels(settings.sensors, metrics);
  noteWhatIsMissing(metrics);
  if (hasResults(metrics))
  {
    outputs.finish(maps, track, last_stamp);
    return concluded(metrics, outputs.folder());
  }
  return concluded(metrics, {});
}

ExitCode mergeThem(const Command& command)
{
  RunMetrics metrics;
  const Interrupt interrupt;
  const std::filesystem::path folder = mergeFolders(command, metrics);
  return concluded(metrics, folder);
}

/** Maps from an octree: the whole of it is there or the file is refused. */
ExitCode rebuildIt(const Settings& settings)
{
  RunMetrics metrics;
  metrics.rawlog = settings.rebuild.string();
  metrics.pose_source = "octree";
  metrics.warnings = settings.warnings;
  const Interrupt interrupt;
  std::vector<BuiltMap> maps = buildMaps(settings.ini, settings.maps);
  checkRebuildable(maps);
  Outputs outputs(settings, metrics);
  mapOctree(settings, maps, metrics);
  noteWhatIsMissing(metrics);
  if (hasResults(metrics))
  {
    outputs.finish(maps, poses::PoseTrack::constant(Eigen::Isometry3d::Identity()), 0);
    return concluded(metrics, outputs.folder());
  }
  return concluded(metrics, {});
}

ExitCode runCommand(const Command& command)
{
  if (command.print_defaults || command.print_options)
  {
    std::cout << (command.print_defaults ? defaultsIni() : optionTables());
    return ExitCode::done;
  }
  if (!command.merge.empty())
  {
    return mergeThem(command);
  }
  if (!command.why.empty())
  {
    return printWhy("traverse-map", command.config, command.why);
  }
  if (!command.index.empty())
  {
    std::cout << writeIndex(command.index, command.force).string() << "\n";
    return ExitCode::done;
  }
  const Settings settings = loadSettings(command);
  if (command.check_config)
  {
    buildChecked(settings);
    tell("warning", settings.warnings);
    std::cout << command.config.string() << ": ok\n";
    return ExitCode::done;
  }
  if (settings.rawlog.empty() || settings.output.empty())
  {
    tell(
        "error", {settings.rawlog.empty()
                      ? "no log: give --rawlog FILE, or rawlog in [traverse-map]"
                      : "no output folder: give --output DIR, or output in [traverse-map]"});
    return ExitCode::usage;
  }
  return settings.rebuild.empty() ? mapIt(settings) : rebuildIt(settings);
}
}  // namespace

ExitCode runMapApp(int argc, const char* const* argv)
{
  plugin::registerAllMaps();
  const Parsed<Command> parsed = parseCommandLine(argc, argv);
  if (!parsed.command)
  {
    return parsed.exit_code;
  }
  const auto tell_one = [](const std::string& kind, const std::string& message)
  { tell(kind, {message}); };
  return reported(
      tell_one,
      [&]
      {
        try
        {
          return runCommand(*parsed.command);
        }
        catch (const logs::LogError& e)
        {
          tell("input", {e.what()});
        }
        catch (const formats::FormatError& e)
        {
          tell("input", {e.what()});
        }
        return ExitCode::unreadable;
      });
}
}  // namespace traverse::app
