// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"

#include <filesystem>
#include <string>

namespace traverse::app
{
/** DIR.parts: what is finished of a run, so that the same run goes on where it was killed. Whoever
 * has it must have locked DIR (formats::OutputFolder). */
class PartStore
{
 public:
  /** `made_of` says all that the parts depend on; parts of anything else are removed. Throws
   * formats::FileError, also for a folder that is none of ours. */
  PartStore(const std::filesystem::path& output, const std::string& made_of);

  /** False also for a part that is damaged or cannot be read: it is made again. */
  bool has(size_t number) const;

  /** Durable once it returns. Throws formats::FileError. */
  void put(size_t number, const Part& part) const;

  /** Throws formats::FileError, and formats::FormatError where the bytes are not those of put().
   */
  Part get(size_t number) const;

  /** When they are not needed any more. */
  void remove() const;

 private:
  std::filesystem::path logOf(size_t number) const;
  std::filesystem::path labelsOf(size_t number) const;

  std::filesystem::path folder_;
};
}  // namespace traverse::app
