// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/ghosts.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace traverse::evaluation
{
namespace
{
using Cells = std::set<std::pair<int32_t, int32_t>>;

std::vector<Cells> setsOf(const std::vector<ObstacleFrame>& frames)
{
  std::vector<Cells> sets(frames.size());
  for (size_t i = 0; i < frames.size(); ++i)
  {
    for (const geometry::CellIndex c : frames[i].obstacles)
    {
      sets[i].emplace(c.x, c.y);
    }
  }
  return sets;
}

size_t firstFrameFrom(const std::vector<ObstacleFrame>& frames, double time_s)
{
  const auto first = std::lower_bound(
      frames.begin(), frames.end(), time_s,
      [](const ObstacleFrame& frame, double t) { return frame.time_s < t; });
  return static_cast<size_t>(first - frames.begin());
}
}  // namespace

double GhostScore::mean_s() const
{
  return seconds.empty() ? std::numeric_limits<double>::quiet_NaN()
                         : std::accumulate(seconds.begin(), seconds.end(), 0.0) /
                               static_cast<double>(seconds.size());
}

double GhostScore::percentile_s(double share) const
{
  if (seconds.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double rank = std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(seconds.size()));
  return seconds[static_cast<size_t>(std::max(rank, 1.0)) - 1];
}

GhostScore ghostScore(
    const std::vector<ObstacleFrame>& frames, const std::vector<Departure>& departures)
{
  const auto later = [](const ObstacleFrame& a, const ObstacleFrame& b)
  { return !(a.time_s <= b.time_s); };
  if (std::adjacent_find(frames.begin(), frames.end(), later) != frames.end())
  {
    throw std::invalid_argument("frames must be in the order of time");
  }
  const std::vector<Cells> obstacles = setsOf(frames);
  GhostScore score;
  for (const Departure& departure : departures)
  {
    const size_t first = firstFrameFrom(frames, departure.left_s);
    if (first == frames.size() || frames[first].time_s >= departure.again_s)
    {
      ++score.unseen;
      continue;
    }
    const std::pair<int32_t, int32_t> cell(departure.cell.x, departure.cell.y);
    size_t i = first;
    double last_s = departure.left_s;  // until when it is known to be a ghost
    while (i < frames.size() && frames[i].time_s < departure.again_s && obstacles[i].contains(cell))
    {
      last_s = frames[i].time_s;
      ++i;
    }
    const bool cleared = i < frames.size() && frames[i].time_s < departure.again_s;
    score.never_cleared += cleared ? 0 : 1;
    const double end_s = cleared && i > first ? frames[i].time_s : last_s;
    score.seconds.push_back(end_s - departure.left_s);
  }
  std::sort(score.seconds.begin(), score.seconds.end());
  return score;
}
}  // namespace traverse::evaluation
