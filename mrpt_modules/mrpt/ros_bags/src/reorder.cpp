// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reorder.h"

#include <algorithm>

namespace traverse::ros_bags
{
namespace
{
constexpr size_t kMostWaiting = 10'000;
constexpr size_t kMostBytes = size_t{512} << 20U;
}  // namespace

void Reorder::add(Pending pending)
{
  now_ns_ = std::max(now_ns_, pending.recorded_ns);
  late_ += pending.stamp_ns < last_taken_ns_ ? 1 : 0;
  bytes_ += pending.bytes;
  recorded_.emplace(pending.recorded_ns, pending.stamp_ns);
  const int64_t stamp_ns = pending.stamp_ns;
  waiting_.emplace(stamp_ns, std::move(pending));
}

/** The one recorded first has waited long enough, so the smallest stamp (that one, or one before
 * it) may go. A stamp far in the future waits no longer than any other. */
bool Reorder::ready() const
{
  return !waiting_.empty() && (ended_ || now_ns_ - recorded_.begin()->first > window_ns_ ||
                               waiting_.size() > kMostWaiting || bytes_ > kMostBytes);
}

std::vector<Pending> Reorder::takeReady()
{
  std::vector<Pending> ready_ones;
  if (!ready())
  {
    return ready_ones;
  }
  const auto [first, last] = waiting_.equal_range(waiting_.begin()->first);
  for (auto it = first; it != last; ++it)
  {
    Pending& pending = it->second;
    bytes_ -= pending.bytes;
    const auto [from, to] = recorded_.equal_range(pending.recorded_ns);
    recorded_.erase(
        std::find_if(from, to, [&](const auto& r) { return r.second == pending.stamp_ns; }));
    last_taken_ns_ = std::max(last_taken_ns_, pending.stamp_ns);
    ready_ones.push_back(std::move(pending));
  }
  waiting_.erase(first, last);
  return ready_ones;
}
}  // namespace traverse::ros_bags
