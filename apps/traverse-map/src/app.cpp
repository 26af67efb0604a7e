// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "map_set.h"
#include "mapping.h"
#include "outputs.h"
#include "settings.h"
#include "track.h"

#include <traverse/common_app/interrupt.h>
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

/** The exit code of a run that came to its end. */
ExitCode verdict(const RunMetrics& metrics)
{
  if (const auto interrupted = Interrupt::exitCode())
  {
    return *interrupted;
  }
  if (metrics.scans == 0)
  {
    return ExitCode::unreadable;
  }
  return metrics.complete ? ExitCode::done : ExitCode::partial;
}

/** What a user must know of a map that did not take everything. */
void noteAbout(const MapMetrics& map, RunMetrics& metrics)
{
  constexpr uint64_t kTenth = 10;  // a log's first and last scans often have no pose
  if (map.scans == 0 && map.outside > 0)
  {
    metrics.problems.push_back(
        fmt::format("{}: all {} points lie outside its extent", map.name, map.outside));
    metrics.complete = false;
  }
  else if (map.scans == 0)
  {
    metrics.problems.push_back(fmt::format(
        "{}: no scan was inserted ({} of {} had no valid pose; [Poses] source = {})", map.name,
        map.scans_no_pose, metrics.scans, metrics.pose_source));
    if (metrics.poses["kept"] == 0)
    {
      metrics.problems.push_back(fmt::format(
          "the log has no poses of source '{}': try [Poses] source = icp_2d, or identity for a "
          "robot that stands still",
          metrics.pose_source));
    }
    metrics.complete = false;
  }
  else if (map.scans_no_pose > 0)
  {
    metrics.warnings.push_back(fmt::format(
        "{}: {} of {} scans had no valid pose", map.name, map.scans_no_pose, metrics.scans));
  }
  if (map.scans_no_pose * kTenth > metrics.scans)
  {
    metrics.complete = false;
  }
  if (map.over_budget > 0)
  {
    metrics.complete = false;
    metrics.warnings.push_back(
        fmt::format("{}: {} points found no room; raise max_memory_mb", map.name, map.over_budget));
  }
}

void noteWhatIsMissing(RunMetrics& metrics)
{
  if (Interrupt::exitCode())
  {
    metrics.complete = false;
    metrics.problems.emplace_back(
        metrics.scans == 0 ? "interrupted before anything was mapped"
                           : "interrupted: what was finished is saved");
  }
  if (metrics.scans == 0 && metrics.problems.empty())
  {
    metrics.problems.push_back(
        fmt::format("{}: no observation in it became points", metrics.rawlog));
  }
  if (metrics.scans == 0)
  {
    return;
  }
  if (const uint64_t skewed = metrics.deskew["no_poses"]; skewed > 0)
  {
    metrics.warnings.push_back(fmt::format(
        "{} of {} scans are not corrected for motion: no poses at the times of their points",
        skewed, metrics.scans));
  }
  for (const MapMetrics& map : metrics.maps)
  {
    noteAbout(map, metrics);
  }
}

ExitCode mapIt(const Settings& settings)
{
  RunMetrics metrics;
  metrics.rawlog = settings.rawlog.string();
  metrics.warnings = settings.warnings;
  const Interrupt interrupt;
  std::vector<BuiltMap> maps = buildMaps(settings);
  Outputs outputs(settings, metrics);
  const poses::PoseTrack track = metrics.times.during(
      "poses", [&] { return makeTrack(settings, metrics, Interrupt::flag()); });
  poses::TimeNs last_stamp = 0;
  mapLog(
      settings, track, maps, metrics,
      [&](poses::TimeNs stamp)
      {
        last_stamp = stamp;
        outputs.snapshot(maps, track, stamp);
      });
  noteWhatIsMissing(metrics);
  if (metrics.scans > 0)
  {
    outputs.finish(maps, track, last_stamp);
    std::cout << (outputs.folder() / "report.html").string() << "\n";
  }
  tell("warning", metrics.warnings);
  tell("problem", metrics.problems);
  return verdict(metrics);
}

ExitCode runCommand(const Command& command)
{
  if (command.print_defaults || command.print_options)
  {
    std::cout << (command.print_defaults ? defaultsIni() : optionTables());
    return ExitCode::done;
  }
  const Settings settings = loadSettings(command);
  if (command.check_config)
  {
    buildMaps(settings);
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
  return mapIt(settings);
}
}  // namespace

ExitCode runMapApp(int argc, const char* const* argv)
{
  plugin::registerAllMaps();
  const ParsedCommand parsed = parseCommandLine(argc, argv);
  if (!parsed.command)
  {
    return parsed.exit_code;
  }
  try
  {
    return runCommand(*parsed.command);
  }
  catch (const config::ConfigError& e)
  {
    tell("configuration", {e.what()});
    return ExitCode::configuration;
  }
  catch (const logs::LogError& e)
  {
    tell("input", {e.what()});
    return ExitCode::unreadable;
  }
  catch (const formats::FormatError& e)
  {
    tell("input", {e.what()});
    return ExitCode::unreadable;
  }
  catch (const formats::FileError& e)
  {
    tell("file", {e.what()});
    return ExitCode::internal;
  }
  catch (const std::exception& e)
  {
    tell("internal error", {e.what()});
    return ExitCode::internal;
  }
}
}  // namespace traverse::app
