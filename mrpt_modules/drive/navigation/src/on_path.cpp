// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/on_path.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
OnPath nearestOn(std::span<const PathPoint> path, Place place)
{
  OnPath best;
  for (size_t k = 0; k < path.size(); ++k)
  {
    const PathPoint& to = path[k];
    const PathPoint& from = path[k == 0 ? 0 : k - 1];
    const double dx = to.pose.x_m - from.pose.x_m;
    const double dy = to.pose.y_m - from.pose.y_m;
    const double squared = dx * dx + dy * dy;
    const double along = (place.x_m - from.pose.x_m) * dx + (place.y_m - from.pose.y_m) * dy;
    const double share = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    const Place nearest = {from.pose.x_m + share * dx, from.pose.y_m + share * dy};
    const double off_x = place.x_m - nearest.x_m;
    const double off_y = place.y_m - nearest.y_m;
    const double off_m = std::sqrt(off_x * off_x + off_y * off_y);
    if (off_m < best.off_m)
    {
      best = {k, nearest, from.along_m + share * (to.along_m - from.along_m), off_m};
    }
  }
  return best;
}
}  // namespace traverse::navigation
