// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace traverse::formats
{
/** A file too large for the memory: it grows under the name FILE.partial and takes the name FILE at
 * the end. A reader of FILE sees what was there before or all of the new bytes, also after kill -9
 * or power loss. What a killed run left in FILE.partial is replaced by the next one. */
class StreamedFile
{
 public:
  /** Throws FileError where FILE.partial cannot be made, or another run is writing to it now. */
  explicit StreamedFile(const std::filesystem::path& path);

  /** Removes FILE.partial unless it became FILE. */
  ~StreamedFile();
  StreamedFile(const StreamedFile&) = delete;
  StreamedFile& operator=(const StreamedFile&) = delete;

  /** Throws FileError where the disk refuses. */
  void write(std::string_view bytes);

  /** Bytes so far. */
  uint64_t size() const { return size_; }

  /** All bytes are on the disk after this, still as FILE.partial; no write() comes later. Throws
   * FileError. */
  void finish();

  /** Gives the file its name, after finish(). Throws FileError, with an old FILE intact. */
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
  uint64_t size_ = 0;
};
}  // namespace traverse::formats
