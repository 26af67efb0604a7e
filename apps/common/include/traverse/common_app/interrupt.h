// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/exit_code.h>

#include <atomic>
#include <optional>

namespace traverse::app
{
/** While one lives, SIGINT and SIGTERM set a flag instead of ending the process. One at a time. */
class Interrupt
{
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /** For loops and readers to look at. */
  static const std::atomic<bool>& flag();

  /** interrupted or terminated, once a signal came. */
  static std::optional<ExitCode> exitCode();
};
}  // namespace traverse::app
