// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace traverse::formats
{
/** May an output folder that is there be replaced? */
enum class Overwrite
{
  refuse,   //!< only a missing or empty folder will do
  replace,  //!< also a folder that a run made (it has a metrics.json); never any other
};

/** The results of one run. They are written to DIR.partial, which takes the name DIR at the end: a
 * reader of DIR sees what was there before or all of the new results, also after kill -9 or power
 * loss. What a killed run left in DIR.partial is replaced by the next one. */
class OutputFolder
{
 public:
  /** The file that is written last; DIR without it is not a result. */
  static constexpr std::string_view kLastFile = "metrics.json";

  /** Checks all that can be checked before anything is computed, locks, and makes DIR.partial.
   *
   * Throws FileError where DIR is there and may not be replaced, its parent is missing or cannot be
   * written, or another run is writing to it now. A DIR that is a symbolic link is followed. */
  OutputFolder(const std::filesystem::path& directory, Overwrite mode);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /** DIR.partial, for those that insist on writing files themselves (commit syncs those too). */
  const std::filesystem::path& path() const { return partial_; }

  /** DIR. */
  const std::filesystem::path& finalPath() const { return final_; }

  /** Writes and syncs one file. `name` is a plain file name that is new in the folder (see
   * safeFileName), otherwise std::invalid_argument; throws FileError where the disk refuses. */
  void write(const std::string& name, std::string_view bytes);

  /** Gives the folder its name. The last file written must be kLastFile (std::logic_error). Throws
   * FileError, with an old DIR intact. */
  void commit();

 private:
  struct Lock;

  void checkTarget() const;
  void lockPartial();
  void swapWithOld();

  Overwrite mode_;
  std::filesystem::path final_;
  std::filesystem::path partial_;
  std::unique_ptr<Lock> lock_;
  std::string last_written_;
};
}  // namespace traverse::formats
