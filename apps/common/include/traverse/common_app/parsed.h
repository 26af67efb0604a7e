// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

#include <optional>

namespace traverse::app
{
/** What a command line asks for, or the exit code where nothing is left to do (--help, --version,
 * wrong usage; the text is printed, help on stdout and complaints on stderr). */
template <class Command>
struct Parsed
{
  std::optional<Command> command;
  ExitCode exit_code = ExitCode::done;
};
}  // namespace traverse::app
