// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "defaults.h"
#include "metrics.h"
#include "outputs.h"
#include "watcher.h"

#include <traverse/common_app/failures.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/safe_file.h>
#include <traverse/logs/log_report.h>
#include <traverse/nav_app/app.h>
#include <traverse/plugin/register.h>

#include <cstdlib>
#include <fmt/format.h>
#include <iostream>

namespace traverse::app
{
namespace
{
void tell(const std::string& kind, const std::string& message)
{
  fmt::print(stderr, "traverse-nav: {}: {}\n", kind, message);
}

/** Collision grids take seconds to compute and depend on the vehicle only: kept where programs keep
 * such things. */
std::filesystem::path cacheFolder()
{
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache != nullptr && *cache != '\0')
  {
    return std::filesystem::path(cache) / "traverse";
  }
  return home != nullptr && *home != '\0' ? std::filesystem::path(home) / ".cache" / "traverse"
                                          : std::filesystem::temp_directory_path() / "traverse";
}

void tellWhy(const Pilot& pilot, const std::array<double, 2>& place_m)
{
  for (const layers::Fact& fact : pilot.explain(place_m[0], place_m[1]))
  {
    fmt::print(stderr, "{}: {}\n", fact.key, fact.value);
  }
}

DriveOptions watchedBy(Watcher& watcher)
{
  DriveOptions options;
  options.stop = &Interrupt::flag();
  options.watch = [&](const Pilot& at, const DriveResult& so_far) { watcher.see(at, so_far); };
  return options;
}

formats::OutputFolder folderOf(const NavCommand& command)
{
  return formats::OutputFolder(
      command.output, command.force ? formats::Overwrite::replace : formats::Overwrite::refuse);
}

/** What is said at the end of a run of either kind. */
ExitCode concluded(
    const NavCommand& command, const Pilot& pilot, const DriveResult& result, const Json& metrics)
{
  if (command.why)
  {
    tellWhy(pilot, *command.why);
  }
  std::cout << textOf(metrics) << "\n";
  return result.interrupted ? Interrupt::exitCode().value_or(ExitCode::interrupted)
                            : ExitCode::done;
}

ExitCode navigate(const NavCommand& command, const NavSettings& settings)
{
  const Interrupt interrupt;
  const Mission mission = readMission(settings, command.seed);
  formats::OutputFolder folder = folderOf(command);
  Pilot pilot(settings, cacheFolder(), folder.path());
  Watcher watcher(settings, command.quiet);
  const DriveResult result = drive(settings, mission, command.seed, pilot, watchedBy(watcher));
  watcher.finish(folder);
  const Json metrics =
      driveMetrics(settings, pilot, result, optimum_m(settings, mission), command.seed);
  writeDrive(folder, settings, pilot, mission.goals, result, metrics);
  folder.commit();
  return concluded(command, pilot, result, metrics);
}

ExitCode replayLog(const NavCommand& command, const NavSettings& settings)
{
  const Interrupt interrupt;
  formats::OutputFolder folder = folderOf(command);
  Pilot pilot(settings, cacheFolder(), folder.path());
  Watcher watcher(settings, command.quiet);
  const ReplayResult result = replay(settings, command.replay, pilot, watchedBy(watcher));
  if (result.records.empty())
  {
    tell("input", result.problem.empty() ? "the log has no scan with a pose" : result.problem);
    return ExitCode::unreadable;
  }
  watcher.finish(folder);
  const Json metrics = replayMetrics(settings, pilot, result, command.replay);
  writeDrive(folder, settings, pilot, {}, result, metrics);
  folder.commit();
  const ExitCode code = concluded(command, pilot, result, metrics);
  if (!result.problem.empty())
  {
    tell("problem", result.problem);
    return ExitCode::partial;
  }
  return code;
}

ExitCode runCommand(const NavCommand& command)
{
  plugin::registerAllMaps();
  if (command.print_defaults)
  {
    std::cout << navDefaultsText();
    return ExitCode::done;
  }
  const NavSettings settings = readNavSettings(command.ini, command.assignments);
  for (const std::string& warning : settings.warnings)
  {
    tell("warning", warning);
  }
  if (command.check_config)
  {
    if (!settings.scene.empty())
    {
      readMission(settings, command.seed);
    }
    return ExitCode::done;
  }
  return command.replay.empty() ? navigate(command, settings) : replayLog(command, settings);
}
}  // namespace

ExitCode runNavApp(int argc, const char* const* argv)
{
  return reported(
      tell,
      [&]
      {
        const Parsed<NavCommand> parsed = parseNavCommand(argc, argv);
        try
        {
          return parsed.command ? runCommand(*parsed.command) : parsed.exit_code;
        }
        catch (const logs::LogError& e)
        {
          tell("input", e.what());
        }
        catch (const formats::FormatError& e)
        {
          tell("input", e.what());
        }
        return ExitCode::unreadable;
      });
}
}  // namespace traverse::app
