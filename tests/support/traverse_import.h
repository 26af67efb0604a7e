// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/data.h"
#include "support/process.h"

#include <string>
#include <vector>

namespace traverse::testing
{
inline std::string importProgram()
{
  return std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-import";
}

/** Runs traverse-import as a user would. */
inline Finished traverseImport(
    const std::filesystem::path& input,
    const std::filesystem::path& output,
    const std::vector<std::string>& options = {})
{
  std::vector<std::string> arguments = {
      importProgram(), input.string(), "--output", output.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run(arguments);
}

/** What stock rawlog-edit says of a log. */
inline std::string stockInfo(const std::filesystem::path& log)
{
  return run({"rawlog-edit", "--info", "-i", log.string()}).out;
}
}  // namespace traverse::testing
