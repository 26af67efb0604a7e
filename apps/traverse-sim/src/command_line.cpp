// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>

namespace traverse::app
{
namespace
{
constexpr const char* kFooter =
    "Example: traverse-sim ini/scenes/street.ini --seed 7 --output street-7\n"
    "The same scene and seed give the same bytes. A run that was interrupted or killed goes on "
    "where "
    "it was when the\n"
    "same command is given again; what is finished waits in DIR.parts.\n"
    "Exit codes: 0 done, 1 internal or output cannot be written, 2 usage, 3 configuration, 130/143 "
    "interrupted.\n"
    "doc/simulation.md says what can be simulated, and what DIR holds.";

RunOptionTexts texts()
{
  return {
      .ini_name = "SCENE.ini",
      .ini = "what there is, what drives, what it records",
      .seed = "of all that is random (1)",
      .check_config = "check the scene, do nothing else",
      .print_defaults = "print every section of a scene file with every key at its default"};
}
}  // namespace

Parsed<SimCommand> parseSimCommand(int argc, const char* const* argv)
{
  SimCommand command;
  CLI::App cli("A log of a simulated scene, with exact truth.", "traverse-sim");
  declare(cli, texts(), command);
  cli.add_option("--threads", command.threads, "0: as many as there are processors (0)")
      ->check(CLI::Range(0, 64));
  cli.set_version_flag("--version", "traverse-sim " TRAVERSE_VERSION);
  cli.footer(kFooter);
  return parse(cli, argc, argv, command, [&] { check(texts(), command); });
}
}  // namespace traverse::app
