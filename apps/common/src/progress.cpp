// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/progress.h>

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace traverse::app
{
Progress::Progress(std::string what, std::string unit, bool quiet) :
    what_(std::move(what)),
    unit_(std::move(unit)),
    quiet_(quiet),
    terminal_(isatty(STDERR_FILENO) == 1)
{
}

double Progress::elapsed_s() const
{
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string Progress::line(double fraction, uint64_t done) const
{
  constexpr int kBar = 24;
  const double spent_s = std::max(elapsed_s(), 1e-3);
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kBar);
  std::string text = fmt::format(
      "{} [{:#<{}}{:.<{}}] {:3.0f} %  {} {}, {:.1f}/s", what_, "", filled, "", kBar - filled,
      100 * std::clamp(fraction, 0.0, 1.0), done, unit_, static_cast<double>(done) / spent_s);
  if (fraction > 0.01 && fraction < 1)
  {
    text += fmt::format(", {:.0f} s left", spent_s * (1 - fraction) / fraction);
  }
  return text;
}

void Progress::show(double fraction, uint64_t done)
{
  const double since_s = std::chrono::duration<double>(Clock::now() - last_).count();
  if (quiet_ || since_s < (terminal_ ? 0.1 : 5.0))
  {
    return;
  }
  last_ = Clock::now();
  fmt::print(
      stderr, "{}{}{}", terminal_ ? "\r" : "", line(fraction, done), terminal_ ? "\033[K" : "\n");
  std::fflush(stderr);
}

void Progress::finish(uint64_t done)
{
  if (!quiet_)
  {
    fmt::print(
        stderr, "{}{}: {} {} in {:.1f} s\n", terminal_ ? "\r\033[K" : "", what_, done, unit_,
        elapsed_s());
  }
}
}  // namespace traverse::app
