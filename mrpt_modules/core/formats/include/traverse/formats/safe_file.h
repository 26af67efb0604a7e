// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace traverse::formats
{
/** A file that cannot be read or written; the message has the path and the system's reason. */
class FileError : public std::runtime_error
{
 public:
  /** "cannot <action> '<path>': <text of code>"; `code` is an errno. */
  FileError(const std::string& action, const std::filesystem::path& path, int code);

  /** "'<path>' <problem>", where the system has no error of its own. */
  FileError(const std::filesystem::path& path, const std::string& problem);

  /** The errno, 0 where there is none. */
  int code() const { return code_; }

 private:
  int code_ = 0;
};

/** Replaces the file by these bytes, durably: a reader, also one after a crash, sees the old file
 * or the whole new one. Throws FileError, with the old file intact and nothing left beside it. */
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/** The bytes of a regular file of at most max_bytes; otherwise FileError. */
std::string readFile(const std::filesystem::path& path, size_t max_bytes);

/** A plain file name made of a label that may be hostile: letters, digits, '.', '_', '-', at most
 * 80 bytes, never hidden, never "." or "..". Labels that need changing get a checksum at the end,
 * so that two of them do not meet in one file. */
std::string safeFileName(std::string_view untrusted_label);
}  // namespace traverse::formats
