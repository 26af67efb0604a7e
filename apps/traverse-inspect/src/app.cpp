// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "doctor.h"
#include "first_clouds.h"
#include "log_summary.h"
#include "map_diff.h"
#include "map_summary.h"
#include "read_scans.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/why.h>
#include <traverse/formats/archive.h>
#include <traverse/formats/safe_file.h>
#include <traverse/inspect_app/app.h>
#include <traverse/plugin/register.h>
#include <traverse/rendering/offscreen.h>

#include <fmt/format.h>
#include <iostream>

namespace traverse::app
{
namespace
{
void tell(const std::string& kind, const std::string& message)
{
  fmt::print(stderr, "traverse-inspect: {}: {}\n", kind, message);
}

std::string line(const Json& json)
{
  return textOf(json) + "\n";
}

/** Says how the log ended. */
ExitCode concluded(const logs::LogReport& report)
{
  if (!report.damage.empty())
  {
    tell("input", report.damage);
  }
  if (const auto interrupted = Interrupt::exitCode())
  {
    return *interrupted;
  }
  if (report.end == logs::LogEnd::not_a_log || report.sensors.empty())
  {
    return ExitCode::unreadable;
  }
  return report.complete() ? ExitCode::done : ExitCode::partial;
}

ExitCode inspectLog(const InspectCommand& command)
{
  ScanCensus census;
  const logs::LogReport report = readScans(
      command.input, command.quiet,
      [&](points::Decoded decoded) { addTo(census, std::move(decoded)); });
  const std::string name = command.input.string();
  if (report.end != logs::LogEnd::not_a_log)
  {
    std::cout
        << (command.json ? line(summaryJson(name, report, census))
                         : summaryText(name, report, census));
  }
  if (!command.pictures.empty())
  {
    for (const std::filesystem::path& file : drawFirstClouds(census, command.pictures))
    {
      (command.json ? std::cerr : std::cout) << file.string() << "\n";
    }
  }
  return concluded(report);
}

ExitCode examineLog(const InspectCommand& command)
{
  const Diagnosis diagnosis = examine(command);
  if (diagnosis.report.end != logs::LogEnd::not_a_log)
  {
    std::cout
        << (command.json ? line({{"hints", hintsJson(diagnosis.hints)}})
                         : hintsText(diagnosis.hints));
  }
  return concluded(diagnosis.report);
}

ExitCode compareMaps(const InspectCommand& command)
{
  const Json diff =
      diffJson(command.diff[0], command.diff[1], {command.tolerance, command.cells_tolerance});
  std::cout << (command.json ? line(diff) : diffText(diff));
  return diff["same"].get<bool>() ? ExitCode::done : ExitCode::internal;  // 1, as diff(1) says it
}

bool isMap(const std::filesystem::path& input)
{
  std::error_code error;
  return input.extension() == ".traverse" || std::filesystem::is_directory(input, error);
}

ExitCode runCommand(const InspectCommand& command)
{
  if (!command.diff.empty())
  {
    return compareMaps(command);
  }
  if (!command.why.empty())
  {
    return printWhy("traverse-inspect", command.input, command.why);
  }
  if (isMap(command.input))
  {
    if (command.doctor || !command.pictures.empty())
    {
      tell("error", "--doctor and --pictures want a log");
      return ExitCode::usage;
    }
    const Json maps = mapsJson(command.input);
    std::cout << (command.json ? line(maps) : mapsText(maps));
    return ExitCode::done;
  }
  const Interrupt interrupt;
  return command.doctor ? examineLog(command) : inspectLog(command);
}

ExitCode failed(ExitCode code, const std::string& kind, const std::exception& e)
{
  tell(kind, e.what());
  return code;
}
}  // namespace

ExitCode runInspectApp(int argc, const char* const* argv)
{
  try
  {
    plugin::registerAllMaps();
    const Parsed<InspectCommand> parsed = parseInspectCommand(argc, argv);
    return parsed.command ? runCommand(*parsed.command) : parsed.exit_code;
  }
  catch (const logs::LogError& e)
  {
    return failed(ExitCode::unreadable, "input", e);
  }
  catch (const formats::FormatError& e)
  {
    return failed(ExitCode::unreadable, "input", e);
  }
  catch (const std::exception& e)
  {
    return failed(ExitCode::internal, "error", e);
  }
}
}  // namespace traverse::app
