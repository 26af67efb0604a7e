// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_stack.h"

#include <algorithm>
#include <tuple>

namespace traverse::simulation
{
Stack Stacker::at(size_t sub, float ground_m)
{
  Stack stack;
  stack.hard_m = ground_m;
  stack.top_m = ground_m;
  if (!pieces_.anyAt(sub))
  {
    return stack;
  }
  sorted_.clear();
  pieces_.forEachAt(sub, [&](const Interval& interval) { sorted_.push_back(interval); });
  std::sort(
      sorted_.begin(), sorted_.end(),
      [](const Interval& a, const Interval& b)
      { return std::tie(a.lo_m, a.hi_m, a.piece) < std::tie(b.lo_m, b.hi_m, b.piece); });
  bool hard_open = true;  // grass may close a gap that is open to what is hard
  for (const Interval& interval : sorted_)
  {
    if (interval.lo_m - stack.top_m >= vehicle_height_m_)
    {
      stack.overhang = true;
      break;
    }
    hard_open = hard_open && interval.lo_m - stack.hard_m < vehicle_height_m_;
    if (interval.hi_m > stack.top_m)
    {
      stack.top_m = interval.hi_m;
      stack.top_object = interval.object;
    }
    if (!interval.yields && hard_open && interval.hi_m > stack.hard_m)
    {
      stack.hard_m = interval.hi_m;
    }
  }
  return stack;
}
}  // namespace traverse::simulation
