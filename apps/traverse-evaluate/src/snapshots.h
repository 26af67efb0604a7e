// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** The class layer of a map at a time. */
struct Snapshot
{
  std::string map;  //!< the file of the map's archive
  std::filesystem::path file;
  double time_s = 0;  //!< since 1970
};

/** Those that a run's metrics.json tells of, in the order of time; none where there is no such file
 * or it tells of none. Throws formats::FormatError for what is damaged. */
std::vector<Snapshot> snapshotsOf(const std::filesystem::path& run);
}  // namespace traverse::app
