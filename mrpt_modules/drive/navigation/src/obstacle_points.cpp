// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/frame2.h>
#include <traverse/navigation/obstacle_points.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
bool isObstacle(const Costmap& costmap, int32_t x, int32_t y)
{
  return costmap.passageAt({x, y}) == Passage::obstacle;
}

/** Whether something beside it, and not only across corners, is no obstacle. */
bool isTouchable(const Costmap& costmap, geometry::CellIndex c)
{
  return !isObstacle(costmap, c.x - 1, c.y) || !isObstacle(costmap, c.x + 1, c.y) ||
         !isObstacle(costmap, c.x, c.y - 1) || !isObstacle(costmap, c.x, c.y + 1);
}

geometry::CellRect cellsWithin(const Costmap& costmap, const geometry::Pose2& pose, double range_m)
{
  const geometry::Lattice& lattice = costmap.lattice;
  const auto first = [&](double from_m, int32_t least, int32_t most)
  {
    const double cell = std::floor(from_m / lattice.cell_m());
    return static_cast<int32_t>(
        std::clamp(cell, static_cast<double>(least), static_cast<double>(most)));
  };
  const geometry::CellRect& all = costmap.extent;
  return {
      {first(pose.x_m - range_m, all.min.x, all.max.x),
       first(pose.y_m - range_m, all.min.y, all.max.y)},
      {first(pose.x_m + range_m + lattice.cell_m(), all.min.x, all.max.x),
       first(pose.y_m + range_m + lattice.cell_m(), all.min.y, all.max.y)}};
}
}  // namespace

std::vector<Eigen::Vector3f> obstaclePoints(
    const Costmap& costmap, const geometry::Pose2& pose, double range_m)
{
  std::vector<Eigen::Vector3f> points;
  const auto frame = geometry::Frame2::of(pose);
  if (!std::isfinite(pose.x_m + pose.y_m + pose.yaw_rad) || !(range_m >= 0))
  {
    return points;
  }
  const geometry::CellRect near = cellsWithin(costmap, pose, range_m);
  for (geometry::CellIndex c = near.min; c.y < near.max.y; ++c.y)
  {
    for (c.x = near.min.x; c.x < near.max.x; ++c.x)
    {
      const double dx = costmap.lattice.centre_m(c.x) - pose.x_m;
      const double dy = costmap.lattice.centre_m(c.y) - pose.y_m;
      if (!isObstacle(costmap, c.x, c.y) || dx * dx + dy * dy > range_m * range_m ||
          !isTouchable(costmap, c))
      {
        continue;
      }
      const float height = costmap.obstacle_m[costmap.indexOf(c)];
      const Eigen::Vector2d seen =
          frame.in({costmap.lattice.centre_m(c.x), costmap.lattice.centre_m(c.y)});
      points.emplace_back(
          static_cast<float>(seen.x()), static_cast<float>(seen.y()),
          height > 0 ? height : kObstacleHeight_m);
    }
  }
  return points;
}
}  // namespace traverse::navigation
