// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

namespace traverse::app
{
/** traverse-inspect: what is in a log or a map, how two maps differ, and what may be wrong with a
 * log. Answers on stdout, talk on stderr. Never throws. */
ExitCode runInspectApp(int argc, const char* const* argv);
}  // namespace traverse::app
