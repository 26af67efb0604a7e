// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>

#include <CLI/CLI.hpp>

namespace traverse::app
{
namespace
{
constexpr const char* kFooter =
    "Examples:\n"
    "  traverse-inspect drive.rawlog                  what is in the log\n"
    "  traverse-inspect --doctor drive.rawlog         what may be wrong with it\n"
    "  traverse-inspect out                           what a run of traverse-map made\n"
    "  traverse-inspect --diff out1 out2              whether two maps are the same\n"
    "Exit codes: 0 done (--diff: same), 1 --diff: they differ, or internal, 2 usage, 4 input "
    "unreadable,\n"
    "5 partial (damaged input, what came before it is shown), 130/143 interrupted.";

void declareDiff(CLI::App& cli, InspectCommand& command)
{
  auto* diff = cli.add_option(
      "--diff", command.diff, "compare two maps (archives or output folders), layer by layer");
  diff->type_name("A B")->expected(2);
  cli.add_option("--tolerance", command.tolerance, "values may differ by so much, in their unit")
      ->check(CLI::NonNegativeNumber)
      ->needs(diff);
  cli.add_option(
         "--cells-tolerance", command.cells_tolerance, "such a share of cells may differ, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->needs(diff);
}

void declareDoctor(CLI::App& cli, InspectCommand& command)
{
  auto* doctor = cli.add_flag(
      "--doctor", command.doctor,
      "hints from the log itself: sensor height and tilt, axes, units, clocks, poses that lag");
  auto* poses = cli.add_option(
      "--poses", command.poses,
      "a source of [Poses] (odometry, robot_pose, ins ...) or a trajectory file (TUM or KITTI); "
      "what "
      "the log has by default");
  poses->type_name("SOURCE|FILE")->needs(doctor);
  cli.add_option("--times", command.times, "one time per row of a KITTI trajectory, s")
      ->type_name("FILE")
      ->needs(poses);
}

void declare(CLI::App& cli, InspectCommand& command)
{
  auto* input = cli.add_option(
      "INPUT", command.input, "a rawlog, a map's archive (*.traverse), or an output folder");
  declareDiff(cli, command);
  declareDoctor(cli, command);
  cli.add_option("--pictures", command.pictures, "draw the first cloud of each sensor into DIR")
      ->type_name("DIR");
  cli.add_option(
         "--why", command.why, "say why the cell at X,Y (m, map frame) of a map is what it is")
      ->type_name("X,Y");
  cli.add_flag("--json", command.json, "answer as one JSON object");
  cli.add_flag("--quiet", command.quiet, "no progress on stderr");
  for (const char* other : {"--doctor", "--pictures", "--why"})
  {
    cli.get_option("--diff")->excludes(cli.get_option(other));
  }
  for (const char* other : {"--doctor", "--pictures", "--json"})
  {
    cli.get_option("--why")->excludes(cli.get_option(other));
  }
  cli.get_option("--doctor")->excludes(cli.get_option("--pictures"));
  cli.get_option("--diff")->excludes(input);
  cli.set_version_flag("--version", "traverse-inspect " TRAVERSE_VERSION);
  cli.footer(kFooter);
}
}  // namespace

Parsed<InspectCommand> parseInspectCommand(int argc, const char* const* argv)
{
  InspectCommand command;
  CLI::App cli("What is in a log or a map, and what may be wrong with it.", "traverse-inspect");
  declare(cli, command);
  return parse(
      cli, argc, argv, command,
      [&]
      {
        if (command.input.empty() && command.diff.empty())
        {
          throw CLI::RequiredError("INPUT");
        }
      });
}
}  // namespace traverse::app
