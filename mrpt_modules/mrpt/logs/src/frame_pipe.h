// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wire.h"

namespace traverse::logs
{
/** The child's end of the pipe: frames are gathered and sent by flush(). */
class FramePipe
{
 public:
  explicit FramePipe(int fd) : fd_(fd) {}

  FrameWriter& frames() { return frames_; }

  /** Throws std::system_error where nobody listens any more. */
  void flush();

 private:
  int fd_;
  FrameWriter frames_;
};
}  // namespace traverse::logs
