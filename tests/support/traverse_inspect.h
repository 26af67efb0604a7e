// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/process.h"

#include <string>
#include <vector>

namespace traverse::testing
{
/** Runs traverse-inspect as a user would, in a plain environment. */
inline Finished traverseInspect(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-inspect");
  return run(arguments, {"DISPLAY="});
}
}  // namespace traverse::testing
