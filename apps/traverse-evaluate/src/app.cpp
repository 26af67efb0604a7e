// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "scores.h"
#include "scores_json.h"
#include "truth_folder.h"
#include "truth_section.h"

#include <traverse/common_app/input_file.h>
#include <traverse/evaluate_app/app.h>
#include <traverse/formats/report_addition.h>
#include <traverse/formats/safe_file.h>
#include <traverse/plugin/register.h>

#include <fmt/format.h>
#include <iostream>

namespace traverse::app
{
namespace
{
void tell(const std::string& kind, const std::string& message)
{
  fmt::print(stderr, "traverse-evaluate: {}: {}\n", kind, message);
}

void addToReport(const std::filesystem::path& run, const Scores& scores)
{
  constexpr size_t kLargest = size_t{512} << 20U;
  const std::filesystem::path file = run / "report.html";
  std::error_code error;
  if (!std::filesystem::exists(file, error))
  {
    tell("note", fmt::format("'{}' is not there: no section was added", file.string()));
    return;
  }
  const std::string page = asInput([&] { return formats::readFile(file, kLargest); });
  std::string longer;
  try
  {
    longer = formats::withAddedSection(page, "against-the-truth", truthSection(scores));
  }
  catch (const formats::FormatError& e)
  {
    throw formats::FormatError(fmt::format("'{}' {}", file.string(), e.what()));
  }
  formats::writeFile(file, longer);
}

ExitCode evaluate(const EvaluateCommand& command)
{
  Scores scores = scoresOfRun(command.run, readTruth(command.truth), command.min_returns);
  scores.truth = command.truth.string();
  for (const MapScores& map : scores.maps)
  {
    if (!map.not_compared.empty())
    {
      tell("note", map.file + " was not compared: " + map.not_compared);
    }
  }
  if (!scores.anyCompared())
  {
    tell(
        "input",
        fmt::format("no map of '{}' can be compared with this truth", command.run.string()));
    return ExitCode::unreadable;
  }
  const std::string json = scoresJson(scores);
  if (!command.output.empty())
  {
    formats::writeFile(command.output, json);
  }
  if (!command.no_report)
  {
    addToReport(command.run, scores);
  }
  std::cout << json;
  return ExitCode::done;
}
}  // namespace

ExitCode runEvaluateApp(int argc, const char* const* argv)
{
  try
  {
    plugin::registerAllMaps();
    const Parsed<EvaluateCommand> parsed = parseEvaluateCommand(argc, argv);
    return parsed.command ? evaluate(*parsed.command) : parsed.exit_code;
  }
  catch (const formats::FormatError& e)
  {
    tell("input", e.what());
    return ExitCode::unreadable;
  }
  catch (const formats::FileError& e)
  {
    tell("output", e.what());
    return ExitCode::internal;
  }
  catch (const std::exception& e)
  {
    tell("error", e.what());
    return ExitCode::internal;
  }
}
}  // namespace traverse::app
