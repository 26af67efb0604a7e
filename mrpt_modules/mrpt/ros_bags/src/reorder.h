// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/source.h>

#include <cstdint>
#include <map>
#include <vector>

namespace traverse::ros_bags
{
/** What a message became, on its way into the log. */
struct Pending
{
  importing::Entry entry;
  int64_t stamp_ns = 0;
  int64_t recorded_ns = 0;
  size_t bytes = 0;   //!< about what it takes
  std::string topic;  //!< for depth and colour images: to find each other
  std::string frame;
};

/** Puts observations into the order of their stamps; holds a bounded amount. Equal stamps keep the
 * order of recording. One whose stamp is further from the time of its recording than the window
 * (another clock) has its place by that time instead, and holds nothing up. */
class Reorder
{
 public:
  explicit Reorder(int64_t window_ns) : window_ns_(window_ns) {}

  void add(Pending pending);

  /** No more will come. */
  void end() { ended_ = true; }

  /** All observations of the first place, once nothing can come before it; else none. */
  std::vector<Pending> takeReady();

  /** Observations that came too late to be put right. */
  uint64_t late() const { return late_; }

  /** Observations of another clock than the recording's. */
  uint64_t strange() const { return strange_; }

 private:
  int64_t placeOf(const Pending& pending) const;
  bool ready() const;

  int64_t window_ns_;
  std::multimap<int64_t, Pending> waiting_;   // by place
  std::multimap<int64_t, int64_t> recorded_;  // of those: recorded at, place
  int64_t now_ns_ = INT64_MIN;                // of the recording
  int64_t last_taken_ns_ = INT64_MIN;
  size_t bytes_ = 0;
  uint64_t late_ = 0;
  uint64_t strange_ = 0;
  bool ended_ = false;
};
}  // namespace traverse::ros_bags
