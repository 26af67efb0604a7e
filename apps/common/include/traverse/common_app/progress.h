// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace traverse::app
{
/** Says on stderr how far the work is: a bar with rate and ETA on a terminal, a line every few
 * seconds otherwise, nothing where quiet. */
class Progress
{
 public:
  Progress(std::string what, std::string unit, bool quiet);

  /** fraction in 0..1 of all the work; done counts `unit`s. */
  void show(double fraction, uint64_t done);

  void finish(uint64_t done);

 private:
  using Clock = std::chrono::steady_clock;

  double elapsed_s() const;
  std::string line(double fraction, uint64_t done) const;

  std::string what_;
  std::string unit_;
  bool quiet_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};
}  // namespace traverse::app
