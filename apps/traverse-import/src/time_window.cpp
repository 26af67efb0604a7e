// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "time_window.h"

#include <chrono>

namespace traverse::app
{
TimeWindow::TimeWindow(std::unique_ptr<importing::Source> source, double from_s, double to_s) :
    source_(std::move(source)), from_s_(from_s), to_s_(to_s)
{
}

std::optional<importing::Entry> TimeWindow::next()
{
  while (auto entry = source_->next())
  {
    const mrpt::Clock::time_point stamp = entry->observation->timestamp;
    first_ = first_.value_or(stamp);
    const double at_s = std::chrono::duration<double>(stamp - *first_).count();
    if (at_s >= from_s_ && at_s < to_s_)
    {
      return entry;
    }
  }
  return std::nullopt;
}
}  // namespace traverse::app
