// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>
#include <traverse/common_app/run_options.h>

namespace traverse::app
{
/** What the command line of traverse-sim says. */
struct SimCommand : RunOptions
{
  int threads = 0;  //!< 0: as many as there are processors
};

Parsed<SimCommand> parseSimCommand(int argc, const char* const* argv);
}  // namespace traverse::app
