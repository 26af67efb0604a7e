// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/source.h>

#include <filesystem>
#include <memory>

namespace traverse::importing
{
/** Writes a gzip rawlog of observations, and its file of point channels beside it. A reader sees
 * the old log or the whole new one, and never a new log without its channels. */
class LogWriter
{
 public:
  /** Throws formats::FileError where the log is there and `replace` is not set, or cannot be
   * written. */
  LogWriter(const std::filesystem::path& log, bool replace);
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  /** Throws formats::FileError where the disk refuses. */
  void add(const Entry& entry);

  /** Gives the files their names. Throws formats::FileError, with an old log intact. */
  void commit();

  /** True where some cloud had channels. */
  bool hasChannels() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};
}  // namespace traverse::importing
