// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>
#include <traverse/common_app/why.h>

namespace traverse::app
{
namespace
{
constexpr const char* kFooter =
    "Example: traverse-nav ini/nav_differential.ini --seed 7 --output drive-7\n"
    "The same ini and seed give the same drive. DIR holds report.html, metrics.json, the driven "
    "way\n"
    "(trajectory.tum, drive.csv), decisions.csv, the maps, and .reactivenavlog for MRPT's "
    "navlog-viewer.\n"
    "Exit codes: 0 done (also where the goal was not reached: metrics.json says so), 1 internal or "
    "output\ncannot be written, 2 usage, 3 configuration, 4 the log cannot be used, 5 the log is "
    "damaged (what came\nbefore is there), 130/143 interrupted.";

RunOptionTexts texts()
{
  return {
      .ini_name = "CONFIG.ini",
      .ini = "vehicle, sensors, maps, costs, and the world",
      .seed = "of the world and of all noise (1)",
      .check_config = "check the ini, do nothing else",
      .print_defaults = "print every section with every key at its default"};
}
}  // namespace

Parsed<NavCommand> parseNavCommand(int argc, const char* const* argv)
{
  NavCommand command;
  CLI::App cli(
      "Drives a simulated vehicle by the maps of an ini, or says what it would have commanded one "
      "that recorded a log.",
      "traverse-nav");
  declare(cli, texts(), command);
  cli.add_option(
         "--replay", command.replay,
         "a recorded log: what would have been commanded (by [Poses], [Sensors]; no scene)")
      ->type_name("LOG");
  cli.add_option_function<std::string>(
         "--why",
         [&](const std::string& text)
         {
           command.why = placeOf(text);
           if (!command.why)
           {
             throw CLI::ValidationError("--why", "wants X,Y in metres, e.g. 3.5,-2; not " + text);
           }
         },
         "say on stderr what the costs at a place consist of, at the end")
      ->type_name("X,Y");
  cli.set_version_flag("--version", "traverse-nav " TRAVERSE_VERSION);
  cli.footer(kFooter);
  return parse(cli, argc, argv, command, [&] { check(texts(), command); });
}
}  // namespace traverse::app
