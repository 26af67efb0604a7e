// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>
#include <traverse/common_app/why.h>

#ifndef TRAVERSE_VERSION
#define TRAVERSE_VERSION "unknown"
#endif

namespace traverse::app
{
namespace
{
constexpr const char* kFooter =
    "Example: traverse-nav ini/nav_clutter.ini --seed 7 --output drive-7\n"
    "The same ini and seed give the same drive. DIR holds report.html, metrics.json, the driven "
    "way\n"
    "(trajectory.tum, drive.csv), decisions.csv, the maps, and .reactivenavlog for MRPT's "
    "navlog-viewer.\n"
    "Exit codes: 0 done (also where the goal was not reached: metrics.json says so), 1 internal or "
    "output\ncannot be written, 2 usage, 3 configuration, 130/143 interrupted.";

void declare(CLI::App& cli, NavCommand& command)
{
  cli.add_option("CONFIG.ini", command.config, "vehicle, sensors, maps, costs, and the world");
  cli.add_option("--output", command.output, "folder to write")->type_name("DIR");
  cli.add_option("--seed", command.seed, "of the world and of all noise")->capture_default_str();
  cli.add_option("--set", command.assignments, "override one key; may be given many times")
      ->type_name("SECTION.KEY=VALUE")
      ->expected(1)
      ->take_all();
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
  cli.add_flag("--check-config", command.check_config, "check the ini, do nothing else");
  cli.add_flag(
      "--print-defaults", command.print_defaults,
      "print every section with every key at its default");
  cli.add_flag("--force", command.force, "replace an output folder that is there");
  cli.add_flag("--quiet", command.quiet, "no progress on stderr");
  cli.set_version_flag("--version", "traverse-nav " TRAVERSE_VERSION);
  cli.footer(kFooter);
}
}  // namespace

Parsed<NavCommand> parseNavCommand(int argc, const char* const* argv)
{
  NavCommand command;
  CLI::App cli("Drives a simulated vehicle by the maps of an ini.", "traverse-nav");
  declare(cli, command);
  return parse(
      cli, argc, argv, command,
      [&]
      {
        if (command.print_defaults)
        {
          return;
        }
        if (command.config.empty())
        {
          throw CLI::RequiredError("CONFIG.ini");
        }
        if (command.output.empty() && !command.check_config)
        {
          throw CLI::RequiredError("--output");
        }
      });
}
}  // namespace traverse::app
