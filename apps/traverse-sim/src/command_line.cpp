// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <system_error>

#ifndef TRAVERSE_VERSION
#define TRAVERSE_VERSION "unknown"
#endif

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

/** CLI11 takes -1 and what is too large for the largest number, and 010 for 8. */
uint64_t seedOf(const std::string& text)
{
  uint64_t seed = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || stop != text.data() + text.size())
  {
    throw CLI::ValidationError(
        "--seed", fmt::format(
                      "'{}': allowed: whole numbers from 0 to {}", text,
                      std::numeric_limits<uint64_t>::max()));
  }
  return seed;
}

void declare(CLI::App& cli, SimCommand& command)
{
  cli.add_option("SCENE.ini", command.scene, "what there is, what drives, what it records");
  cli.add_option("--output", command.output, "folder to write")->type_name("DIR");
  cli.add_option_function<std::string>(
         "--seed", [&](const std::string& text) { command.seed = seedOf(text); },
         "of all that is random (1)")
      ->type_name("N");
  cli.add_option("--threads", command.threads, "0: as many as there are processors (0)")
      ->check(CLI::Range(0, 64));
  cli.add_option("--set", command.assignments, "override one key; may be given many times")
      ->type_name("SECTION.KEY=VALUE")
      ->expected(1)
      ->take_all();
  cli.add_flag("--check-config", command.check_config, "check the scene, do nothing else");
  cli.add_flag(
      "--print-defaults", command.print_defaults,
      "print every section of a scene file with every key at its default");
  cli.add_flag("--force", command.force, "replace an output folder that is there");
  cli.add_flag("--quiet", command.quiet, "no progress on stderr");
  cli.set_version_flag("--version", "traverse-sim " TRAVERSE_VERSION);
  cli.footer(kFooter);
}
}  // namespace

Parsed<SimCommand> parseSimCommand(int argc, const char* const* argv)
{
  SimCommand command;
  CLI::App cli("A log of a simulated scene, with exact truth.", "traverse-sim");
  declare(cli, command);
  return parse(
      cli, argc, argv, command,
      [&]
      {
        if (command.print_defaults)
        {
          return;
        }
        if (command.scene.empty())
        {
          throw CLI::RequiredError("SCENE.ini");
        }
        if (command.output.empty() && !command.check_config)
        {
          throw CLI::RequiredError("--output");
        }
      });
}
}  // namespace traverse::app
