// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

namespace traverse::app
{
/** traverse-evaluate: scores what a run of traverse-map made against truth. JSON on stdout, talk on
 * stderr. Never throws. */
ExitCode runEvaluateApp(int argc, const char* const* argv);
}  // namespace traverse::app
