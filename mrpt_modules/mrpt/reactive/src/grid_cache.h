// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace traverse::reactive
{
/** Where MRPT keeps the collision grids of one ini: a folder in the cache of its own, as MRPT's
 * file names say nothing of the vehicle. A new folder comes into being whole or not at all, also
 * where two programs make it at once; a damaged one is made anew, as MRPT would tell stderr. */
class GridCache
{
 public:
  /** Makes folders that are missing; throws std::filesystem::filesystem_error. */
  GridCache(const std::filesystem::path& cache, std::string_view ini);
  ~GridCache();
  GridCache(const GridCache&) = delete;
  GridCache& operator=(const GridCache&) = delete;

  /** Where the grids are, or are to be written. */
  const std::filesystem::path& folder() const { return folder_; }

  /** The grids are written: others may have them. */
  void keep();

 private:
  std::filesystem::path kept_;
  std::filesystem::path folder_;
};
}  // namespace traverse::reactive
