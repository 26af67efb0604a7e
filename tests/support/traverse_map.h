// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/data.h"
#include "support/process.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
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

/** The same with a disk of `kilobytes` mounted at `disk`; nothing where that cannot be done here.
 */
inline std::optional<Finished> traverseMapOnTinyDisk(
    const std::filesystem::path& disk, int kilobytes, const std::vector<std::string>& arguments)
{
  std::string script = "mount -t tmpfs -o size=" + std::to_string(kilobytes) + "k none '" +
                       disk.string() + "' && exec '" + TRAVERSE_BINARY_DIR + "/bin/traverse-map'";
  for (const std::string& argument : arguments)
  {
    script += " '" + argument + "'";
  }
  Finished ran = run({"unshare", "--mount", "--map-root-user", "sh", "-c", script});
  const bool was_run = ran.err.find("traverse-map") != std::string::npos;
  return was_run ? std::optional(std::move(ran)) : std::nullopt;
}

/** metrics.json of an output folder. */
inline nlohmann::json metricsOf(const std::filesystem::path& folder)
{
  return nlohmann::json::parse(readText(folder / "metrics.json"));
}
}  // namespace traverse::testing
