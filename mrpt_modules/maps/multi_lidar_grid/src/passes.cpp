// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "azimuth.h"
#include "mapper_work.h"

#include <algorithm>

namespace traverse::multi_lidar_grid
{
/** Whether a beam went on through a cell of the region's x and y between two heights over the
 * ground. */
bool UnitMapper::Work::passedBetween(int32_t x, int32_t y, float from_m, float to_m)
{
  if (origins.empty())
  {
    return false;
  }
  const float cell_m = rules.cell_m();
  const Eigen::Vector2f place(
      (static_cast<float>(x) + 0.5F) * cell_m, (static_cast<float>(y) + 0.5F) * cell_m);
  // The vehicle moves while the sensor turns: the fan that looks there says from where it looked.
  Eigen::Vector3f origin = origins.front();
  size_t fan = 0;
  for (int i = 0; i < 2; ++i)
  {
    const Eigen::Vector2f to = place - origin.head<2>();
    if (to.isZero())
    {
      return false;
    }
    fan = fans.fanOf(turnOf(to.x(), to.y()));
    origin = origins[fan];
  }
  const float along_m = (place - origin.head<2>()).norm();
  const float sensor_m = origin.z() - local_ground->heightAt(x, y);
  const auto height_m = [&](const FanBeam& beam) { return sensor_m + beam.slope * along_m; };
  const std::span<const FanBeam> beams = fans.beams(fan);
  const auto high_enough = std::partition_point(
      beams.begin(), beams.end(), [&](const FanBeam& b) { return height_m(b) < from_m; });
  for (auto beam = high_enough; beam != beams.end() && height_m(*beam) <= to_m; ++beam)
  {
    if (beam->reach_m > along_m + cell_m)
    {
      return true;
    }
  }
  return false;
}

bool UnitMapper::passedBetween(
    const UnitMap& map, geometry::CellIndex cell, double from_m, double to_m) const
{
  const geometry::CellRect& region = map.cells.region();
  return from_m <= to_m && region.contains(cell) &&
         work_->passedBetween(
             cell.x - region.min.x, cell.y - region.min.y, static_cast<float>(from_m),
             static_cast<float>(to_m));
}
}  // namespace traverse::multi_lidar_grid
