// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/data.h"
#include "support/process.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace traverse::testing
{
inline std::string ini(const std::string& name)
{
  return std::string(TRAVERSE_SOURCE_DIR) + "/ini/" + name + ".ini";
}

/** Runs traverse-map as a user would, in a plain environment. */
inline Finished traverseMap(
    std::vector<std::string> arguments, const std::vector<std::string>& environment = {"DISPLAY="})
{
  arguments.insert(arguments.begin(), std::string(TRAVERSE_BINARY_DIR) + "/bin/traverse-map");
  return run(arguments, environment);
}

/** metrics.json of an output folder. */
inline nlohmann::json metricsOf(const std::filesystem::path& folder)
{
  return nlohmann::json::parse(readText(folder / "metrics.json"));
}
}  // namespace traverse::testing
