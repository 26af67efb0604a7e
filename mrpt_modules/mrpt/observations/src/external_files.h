// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace mrpt::obs
{
class CObservation;
}  // namespace mrpt::obs

namespace traverse::observations
{
/** Loads what an observation stores in files beside the log, for as long as this object lives.
 *
 * Throws Refused, before anything is opened, where a name is absolute, has "..", or leads out of
 * the folder by a link, or where a file is missing, not a plain file, or beyond 256 MiB. */
class ExternalFiles
{
 public:
  /** `names`: relative names that the observation's load() will open; none: nothing is done. */
  ExternalFiles(
      const mrpt::obs::CObservation& observation,
      const std::vector<std::string>& names,
      const std::filesystem::path& folder);
  ~ExternalFiles();
  ExternalFiles(const ExternalFiles&) = delete;
  ExternalFiles& operator=(const ExternalFiles&) = delete;

 private:
  const mrpt::obs::CObservation* loaded_ = nullptr;
};
}  // namespace traverse::observations
