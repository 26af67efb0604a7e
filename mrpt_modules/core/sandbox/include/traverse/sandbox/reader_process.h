// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/sandbox/input_file.h>
#include <traverse/sandbox/shared_progress.h>

#include <functional>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace traverse::sandbox
{
/** What a child may use. */
struct ReaderLimits
{
  int memory_mb = 2048;     //!< beyond what the parent takes at the fork, MiB
  double timeout_s = 30.0;  //!< processor time without progress, s
};

/** What the child runs: reads the input, writes frames, returns when done. */
using ReaderJob = std::function<void(int input_fd, int frames_fd, SharedProgress& progress)>;

/** A child process (fork, no exec) that parses a file.
 *
 * It holds no file but its input and the pipes, may not write files, has a bounded memory, and dies
 * with the thread that made it. What it prints is kept for messages, not shown. */
class ReaderProcess
{
 public:
  /** Throws std::system_error where there is no process or pipe to be had. */
  ReaderProcess(int input_fd, const ReaderLimits& limits, const ReaderJob& job);
  ~ReaderProcess();
  ReaderProcess(const ReaderProcess&) = delete;
  ReaderProcess& operator=(const ReaderProcess&) = delete;

  /** Waits up to 50 ms for something to read. */
  void wait();

  /** Appends what the child has written, if anything; false once there is no more to come. */
  bool receive(std::vector<uint8_t>& to);

  /** Why the child must be ended: it takes too much time or memory; empty where it does not. */
  std::string misbehaviour();

  /** Ends the child, if it still runs, and says how it ended: empty for an orderly exit. */
  std::string finish();

  const SharedProgress& progress() const { return *progress_; }

 private:
  void takeTalk();
  std::string lastWords() const;

  struct Unmap
  {
    void operator()(SharedProgress* p) const;
  };

  std::unique_ptr<SharedProgress, Unmap> progress_;
  ReaderLimits limits_;
  pid_t pid_ = -1;
  Fd frames_;
  Fd talk_;
  std::string said_;
  uint64_t memory_limit_bytes_ = 0;
  uint64_t seen_object_ = 0;
  uint64_t seen_bytes_ = 0;
  uint64_t received_ = 0;
  double cpu_then_s_ = 0;
  int waits_ = 0;        // in vain, since the last progress
  bool closed_ = false;  // by the child
};
}  // namespace traverse::sandbox
