// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>

namespace traverse::app
{
namespace
{
constexpr const char* kFooter =
    "Example:\n"
    "  traverse-evaluate out truth              scores on stdout, and a section in "
    "out/report.html\n"
    "Exit codes: 0 done, 1 internal or output cannot be written, 2 usage, 4 input unreadable or\n"
    "nothing in the run can be compared with the truth.";
}  // namespace

Parsed<EvaluateCommand> parseEvaluateCommand(int argc, const char* const* argv)
{
  EvaluateCommand command;
  CLI::App cli("Scores what a run of traverse-map made against truth.", "traverse-evaluate");
  cli.add_option("RUN_DIR", command.run, "output folder of traverse-map")->required();
  cli.add_option(
         "TRUTH_DIR", command.truth, "truth of traverse-sim: truth_*.tif, footprints.geojson ...")
      ->required();
  cli.add_option("--output", command.output, "write the JSON to FILE, too")->type_name("FILE");
  cli.add_option(
         "--min-returns", command.min_returns, "leave out cells with fewer points in the map")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  cli.add_flag("--no-report", command.no_report, "leave RUN_DIR/report.html as it is");
  cli.set_version_flag("--version", "traverse-evaluate " TRAVERSE_VERSION);
  cli.footer(kFooter);
  return parse(cli, argc, argv, command, [] {});
}
}  // namespace traverse::app
