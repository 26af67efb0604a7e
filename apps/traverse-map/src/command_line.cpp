// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <traverse/common_app/parse.h>

#include <CLI/CLI.hpp>
#include <charconv>

namespace traverse::app
{
namespace
{
constexpr const char* kFooter =
    "Exit codes: 0 done, 1 internal or output cannot be written, 2 usage, 3 configuration, 4 input "
    "unreadable,\n"
    "5 partial (damaged input, what came before it was saved), 130/143 interrupted (what was "
    "finished is saved).\n"
    "Results go to stdout, talk to stderr. Start from a file of ini/; doc/options.md says what "
    "each key means.";

/** K/N with 1 <= K <= N. */
Piece pieceOf(const std::string& text)
{
  constexpr uint64_t kMost = 1'000'000;
  Piece piece;
  const char* end = text.data() + text.size();
  const auto k = std::from_chars(text.data(), end, piece.number);
  const bool slash = k.ec == std::errc() && k.ptr != end && *k.ptr == '/';
  const auto n = slash ? std::from_chars(k.ptr + 1, end, piece.of) : k;
  if (!slash || n.ec != std::errc() || n.ptr != end || piece.number < 1 ||
      piece.number > piece.of || piece.of > kMost)
  {
    throw CLI::ValidationError("--piece", "'" + text + "' is not K/N with 1 <= K <= N");
  }
  return piece;
}

void declarePieces(CLI::App& cli, Command& command)
{
  cli.add_option_function<std::string>(
         "--piece", [&](const std::string& text) { command.piece = pieceOf(text); },
         "map only the K-th of N parts of the log")
      ->type_name("K/N");
  auto* merge = cli.add_option(
      "--merge", command.merge,
      "make the map of the whole log from the output folders of all its pieces; needs --output");
  merge->type_name("DIR...");
  for (const char* other :
       {"CONFIG.ini", "--rawlog", "--set", "--piece", "--check-config", "--print-defaults",
        "--print-options"})
  {
    merge->excludes(cli.get_option(other));
  }
}

/** What starts from an earlier run's files. */
void declareMapsOfMaps(CLI::App& cli, Command& command)
{
  auto* rebuild = cli.add_option(
      "--rebuild", command.rebuild,
      "make the ini's maps from an octree (.bt, .ot) instead of a log, for other thresholds or "
      "larger cells");
  rebuild->type_name("FILE");
  auto* why = cli.add_option(
      "--why", command.why,
      "say why the cell at X,Y (m, map frame) is what it is: --why X,Y DIR, with the output "
      "folder DIR in place of the ini");
  why->type_name("X,Y");
  for (const char* other : {"--rawlog", "--piece", "--merge", "--why"})
  {
    rebuild->excludes(cli.get_option(other));
  }
  for (const char* other : {"--output", "--set", "--merge", "--piece", "--check-config"})
  {
    why->excludes(cli.get_option(other));
  }
}

void declareIndex(CLI::App& cli, Command& command)
{
  auto* index = cli.add_option(
      "--index", command.index,
      "write DIR/index.html: a table of the runs whose output folders are in DIR");
  index->type_name("DIR");
  for (const char* other :
       {"CONFIG.ini", "--rawlog", "--output", "--set", "--piece", "--merge", "--rebuild", "--why",
        "--point-labels", "--check-config", "--print-defaults", "--print-options"})
  {
    index->excludes(cli.get_option(other));
  }
}

void declare(CLI::App& cli, Command& command)
{
  cli.add_option("CONFIG.ini", command.config, "what to map and how");
  cli.add_option("--rawlog", command.rawlog, "log to read, instead of the ini's")
      ->type_name("FILE");
  cli.add_option("--output", command.output, "folder to write, instead of the ini's")
      ->type_name("DIR");
  cli.add_option("--set", command.assignments, "override one key; may be given many times")
      ->type_name("SECTION.KEY=VALUE")
      ->expected(1)
      ->take_all();
  cli.add_flag("--check-config", command.check_config, "check the configuration, do nothing else");
  cli.add_flag(
      "--print-defaults", command.print_defaults, "print an ini with every key at its default");
  cli.add_flag("--print-options", command.print_options, "print the table of all keys as Markdown");
  cli.add_flag("--force", command.force, "replace an output folder that is there");
  cli.add_flag("--quiet", command.quiet, "no progress on stderr");
  cli.add_option(
         "--point-labels", command.point_labels,
         "write a label for each point of each cloud: 0 undefined, 1 ground, 2 obstacle, 3 "
         "overhanging")
      ->type_name("DIR");
  declarePieces(cli, command);
  declareMapsOfMaps(cli, command);
  declareIndex(cli, command);
  for (const char* other : {"--piece", "--merge", "--rebuild", "--why"})
  {
    cli.get_option("--point-labels")->excludes(cli.get_option(other));
  }
  cli.set_version_flag("--version", "traverse-map " TRAVERSE_VERSION);
  cli.footer(kFooter);
}
}  // namespace

Parsed<Command> parseCommandLine(int argc, const char* const* argv)
{
  Command command;
  CLI::App cli(
      "Maps of where a ground robot can go, from a log of its range sensors.", "traverse-map");
  declare(cli, command);
  return parse(
      cli, argc, argv, command,
      [&]
      {
        const bool needs_config = command.merge.empty() && command.index.empty() &&
                                  !command.print_defaults && !command.print_options;
        if (needs_config && command.config.empty())
        {
          throw CLI::RequiredError("CONFIG.ini");
        }
        if (!command.merge.empty() && command.output.empty())
        {
          throw CLI::RequiredError("--output");
        }
      });
}
}  // namespace traverse::app
