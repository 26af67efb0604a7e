// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

namespace traverse::app
{
/** traverse-nav: drives a simulated vehicle through a scene with the maps of an ini. Prints metrics
 * as JSON on stdout, all else on stderr; never throws. */
ExitCode runNavApp(int argc, const char* const* argv);
}  // namespace traverse::app
