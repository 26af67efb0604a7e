// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/nav_app/closed_loop.h>

namespace traverse::app
{
/** Counts what happens between one record and the next. */
class Referee
{
 public:
  explicit Referee(DriveResult& result) : result_(result) {}

  /** Before the record is added to the result's. */
  void judge(const DriveRecord& now);

 private:
  DriveResult& result_;
  bool touches_ = false;
  bool moves_ = false;
  bool slips_ = false;
};
}  // namespace traverse::app
