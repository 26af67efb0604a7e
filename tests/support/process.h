// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/scratch_folder.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace traverse::testing
{
/** How a program ended and what it said. */
struct Finished
{
  int exit_code = -1;  //!< 128 + signal where a signal ended it, as a shell says it
  std::string out;
  std::string err;
};

/** A program that runs beside the test; killed at the end if it still does. */
class Process
{
 public:
  /** Starts argv[0] (searched in PATH) with these extra NAME=value settings; stdin is /dev/null or,
   * with keep_stdin, a pipe that stays open. Throws std::runtime_error where it cannot start. */
  explicit Process(
      const std::vector<std::string>& argv,
      const std::vector<std::string>& environment = {},
      bool keep_stdin = false);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void type(const std::string& text) const;  //!< to its stdin
  void signal(int number) const;
  bool running();

  /** Waits; kills after the limit (exit code 128 + 9 then). */
  Finished wait(std::chrono::seconds limit);

 private:
  void reap(bool block);

  pid_t pid_ = -1;
  int stdin_ = -1;
  int status_ = 0;
  bool reaped_ = false;
  std::filesystem::path out_file_;
  std::filesystem::path err_file_;
};

/** Runs a program to its end. */
Finished run(
    const std::vector<std::string>& argv,
    const std::vector<std::string>& environment = {},
    std::chrono::seconds limit = std::chrono::seconds(300));
}  // namespace traverse::testing
