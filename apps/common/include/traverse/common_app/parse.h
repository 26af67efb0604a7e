// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>

#include <CLI/CLI.hpp>
#include <iostream>

namespace traverse::app
{
/** Parses argv into the command that the options of `cli` write to; `check` may throw
 * CLI::ParseError for what options do not see one by one. */
template <class Command, class Check>
Parsed<Command> parse(
    CLI::App& cli, int argc, const char* const* argv, const Command& command, const Check& check)
{
  try
  {
    cli.parse(argc, argv);
    check();
  }
  catch (const CLI::ParseError& e)
  {
    const bool asked_for = cli.exit(e, std::cout, std::cerr) == 0;
    return {std::nullopt, asked_for ? ExitCode::done : ExitCode::usage};
  }
  return {command, ExitCode::done};
}
}  // namespace traverse::app
