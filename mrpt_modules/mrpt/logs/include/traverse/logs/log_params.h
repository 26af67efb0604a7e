// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

#include <atomic>
#include <cstdint>
#include <limits>

namespace traverse::logs
{
/** Section [Log]: what the process that parses a log may use. */
struct LogParams
{
  int reader_memory_mb = 2048;
  double reader_timeout_s = 30.0;

  friend bool operator==(const LogParams&, const LogParams&) = default;
};

template <class P, class F>
void visitLogParams(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "reader_memory_mb",
          "memory that parsing the log may take, MiB; a log that needs more counts as damaged",
          {64, 1048576}},
      p.reader_memory_mb);
  f(
      Option{
          "reader_timeout_s",
          "processor time that one object of the log may take, s; then the log counts as damaged",
          {0.1, 3600}},
      p.reader_timeout_s);
}

template <class F>
void visit(LogParams& p, F&& f)
{
  visitLogParams(p, f);
}

template <class F>
void visit(const LogParams& p, F&& f)
{
  visitLogParams(p, f);
}

/** Entries [first, end) of a log (observations, actions, sensory frames), in file order from 0. */
struct EntryRange
{
  uint64_t first = 0;
  uint64_t end = std::numeric_limits<uint64_t>::max();  //!< by default also what is damaged there
};

/** How the caller wants to be served. */
struct ReadOptions
{
  /** Set from elsewhere (a signal handler) to make a waiting call return soon. */
  const std::atomic<bool>* stop = nullptr;
  /** Takes scans whose stamp is no clock's (they get stamp 0) instead of rejecting them: for
   * PoseSource::identity, where no pose is looked up by time. */
  bool accept_bad_stamps = false;
  /** LogReader: the scans of these entries only, the same as a reader of all would give while it is
   * at them (a tilting sweep comes with the row that shows its end). Entries before are not decoded
   * where nothing depends on them, those behind are not read. */
  EntryRange entries;
};
}  // namespace traverse::logs
