// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "referee.h"

#include <algorithm>
#include <cmath>

namespace traverse::app
{
namespace
{
constexpr double kMoves_mps = 0.05;
constexpr double kStands_mps = 0.02;
}  // namespace

void Referee::judge(const DriveRecord& now)
{
  const double speed = std::abs(now.vehicle.twist.speed_mps);
  result_.min_clearance_m = std::min(result_.min_clearance_m, now.clearance_m);
  if (now.clearance_m < 0 && !touches_)
  {
    ++(speed > kStands_mps ? result_.collisions : result_.struck_standing);
  }
  touches_ = now.clearance_m < 0;
  if (moves_ && speed < kStands_mps)
  {
    ++result_.stops;
  }
  moves_ = speed > kMoves_mps || (moves_ && speed >= kStands_mps);
  result_.slips += now.vehicle.slips && !slips_ ? 1 : 0;
  slips_ = now.vehicle.slips;
  if (!result_.records.empty())
  {
    result_.way_m += geometry::distance_m(result_.records.back().vehicle.pose, now.vehicle.pose);
  }
}
}  // namespace traverse::app
