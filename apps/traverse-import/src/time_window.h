// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/source.h>

#include <memory>

namespace traverse::app
{
/** What a source gives from one time to another, seconds after its first observation; to_s itself
 * not included. */
class TimeWindow : public importing::Source
{
 public:
  TimeWindow(std::unique_ptr<importing::Source> source, double from_s, double to_s);

  std::optional<importing::Entry> next() override;

  double progress() const override { return source_->progress(); }

  const importing::ImportReport& report() const override { return source_->report(); }

 private:
  std::unique_ptr<importing::Source> source_;
  double from_s_;
  double to_s_;
  std::optional<mrpt::Clock::time_point> first_;
};
}  // namespace traverse::app
