// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

namespace traverse::app
{
/** The program traverse-sim. Never throws; talks on stdout and stderr. */
ExitCode runSimApp(int argc, const char* const* argv);
}  // namespace traverse::app
