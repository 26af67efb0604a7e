// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reorder.h"

#include <algorithm>
#include <cstdlib>

namespace traverse::ros_bags
{
namespace
{
constexpr size_t kMostWaiting = 10'000;
constexpr size_t kMostBytes = size_t{512} << 20U;
}  // namespace

int64_t Reorder::placeOf(const Pending& pending) const
{
  const int64_t from_recording = pending.stamp_ns - pending.recorded_ns;
  return std::abs(from_recording) <= window_ns_ ? pending.stamp_ns : pending.recorded_ns;
}

void Reorder::add(Pending pending)
{
  const int64_t place = placeOf(pending);
  now_ns_ = std::max(now_ns_, pending.recorded_ns);
  strange_ += place != pending.stamp_ns ? 1 : 0;
  late_ += place < last_taken_ns_ ? 1 : 0;
  bytes_ += pending.bytes;
  recorded_.emplace(pending.recorded_ns, place);
  waiting_.emplace(place, std::move(pending));
}

/** The one recorded first has waited long enough, so the first place (its own, or one before it)
 * may be taken. */
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
  const int64_t place = waiting_.begin()->first;
  const auto [first, last] = waiting_.equal_range(place);
  for (auto it = first; it != last; ++it)
  {
    Pending& pending = it->second;
    bytes_ -= pending.bytes;
    const auto [from, to] = recorded_.equal_range(pending.recorded_ns);
    recorded_.erase(std::find_if(from, to, [&](const auto& r) { return r.second == place; }));
    ready_ones.push_back(std::move(pending));
  }
  waiting_.erase(first, last);
  last_taken_ns_ = std::max(last_taken_ns_, place);
  return ready_ones;
}
}  // namespace traverse::ros_bags
