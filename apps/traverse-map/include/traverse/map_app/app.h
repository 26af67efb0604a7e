// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

namespace traverse::app
{
/** traverse-map: a log and an ini to maps, pictures, layers, metrics and a report. Results are
 * named on stdout, talk goes to stderr. Never throws. */
ExitCode runMapApp(int argc, const char* const* argv);
}  // namespace traverse::app
