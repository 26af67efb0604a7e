// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_turn.h"

#include <traverse/sensors/velodyne_timing.h>

#include <algorithm>

namespace traverse::points
{
namespace
{
constexpr int64_t kUsPerHour = 3'600'000'000;
constexpr int64_t kUsPerSecond = 1'000'000;
constexpr int64_t kNsPerUs = 1000;
constexpr int kTurn = 36000;  // hundredths of a degree

/** Time from one packet's first firing to the next one's, by the packets' clock where it can be
 * believed. */
int64_t nsBetween(const sensors::VelodyneData& from, const sensors::VelodyneData& to)
{
  int64_t delta_us = int64_t{to.timeUs()} - int64_t{from.timeUs()};
  if (delta_us > kUsPerHour / 2)
  {
    delta_us -= kUsPerHour;
  }
  else if (delta_us < -kUsPerHour / 2)
  {
    delta_us += kUsPerHour;
  }
  if (delta_us >= -kUsPerSecond && delta_us <= kUsPerSecond)
  {
    return delta_us * kNsPerUs;
  }
  return from.groups() * sensors::timingOf(from.model()).blockNs();
}

/** Walks over the azimuths of all groups of a turn. */
class Sweep
{
 public:
  /** Adds a group; the way from the group before it, hundredths of a degree clockwise. */
  int add(uint16_t azimuth)
  {
    constexpr int kBackwardAtMost = 1000;  // packets out of order; more is a long way forward
    int step = 0;
    if (!first_)
    {
      step = (azimuth - last_ + kTurn) % kTurn;
      step = step > kTurn - kBackwardAtMost ? step - kTurn : step;
    }
    first_ = false;
    last_ = azimuth;
    swept_ += step;
    return step;
  }

  int64_t swept() const { return swept_; }

 private:
  bool first_ = true;
  int last_ = 0;
  int64_t swept_ = 0;
};

int medianOf(std::vector<int>& values)
{
  if (values.empty())
  {
    return 0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
}  // namespace

VelodyneTurn checkPackets(std::span<const sensors::VelodynePacket> packets)
{
  VelodyneTurn turn;
  turn.packets.reserve(packets.size());
  for (const sensors::VelodynePacket& bytes : packets)
  {
    const auto data = sensors::VelodyneData::check(bytes);
    if (!data || (!turn.packets.empty() && data->model() != turn.packets.front().data.model()))
    {
      ++turn.bad_packets;
      continue;
    }
    int64_t time_ns = 0;
    if (!turn.packets.empty())
    {
      time_ns = turn.packets.back().time_ns + nsBetween(turn.packets.back().data, *data);
    }
    turn.packets.push_back({*data, time_ns});
  }
  return turn;
}

ColumnPlan planColumns(const VelodyneTurn& turn)
{
  if (turn.packets.empty())
  {
    return {};
  }
  Sweep sweep;
  std::vector<int> steps;
  bool full = false;
  for (size_t p = 0; p < turn.packets.size() && !full; ++p)
  {
    for (int group = 0; group < turn.packets[p].data.groups() && !full; ++group)
    {
      steps.push_back(sweep.add(turn.packets[p].data.azimuth(group)));
      full = sweep.swept() >= kTurn;
    }
  }
  const auto groups = static_cast<int>(steps.size()) - (full ? 1 : 0);
  const auto timing = sensors::timingOf(turn.packets.front().data.model());
  ColumnPlan plan;
  plan.sequences = groups * timing.sequences_per_block;
  plan.step_hundredths_deg = medianOf(steps);
  plan.closes = full || sweep.swept() >= kTurn - 2 * plan.step_hundredths_deg;
  return plan;
}
}  // namespace traverse::points
