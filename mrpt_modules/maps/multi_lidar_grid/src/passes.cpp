// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "azimuth.h"
#include "mapper_work.h"

#include <limits>

namespace traverse::multi_lidar_grid
{
/** Height over the ground, m, at which the lowest beam passed a cell of the region's x and y;
 * infinite where none did. */
float UnitMapper::Work::passOver_m(int32_t x, int32_t y)
{
  constexpr float kNone = std::numeric_limits<float>::infinity();
  if (origins.empty())
  {
    return kNone;
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
      return kNone;
    }
    fan = fans.fanOf(turnOf(to.x(), to.y()));
    origin = origins[fan];
  }
  const float along_m = (place - origin.head<2>()).norm();
  for (const FanBeam& beam : fans.beams(static_cast<int32_t>(fan)))
  {
    if (beam.reach_m > along_m + cell_m)
    {
      const float height_m = origin.z() + beam.slope * along_m - local_ground->heightAt(x, y);
      return height_m == height_m ? height_m : kNone;
    }
  }
  return kNone;
}

bool UnitMapper::passedBelow(const UnitMap& map, geometry::CellIndex cell, double height_m) const
{
  const geometry::CellRect& region = map.cells.region();
  return region.contains(cell) &&
         work_->passOver_m(cell.x - region.min.x, cell.y - region.min.y) < height_m;
}
}  // namespace traverse::multi_lidar_grid
