// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/footprint.h>
#include <traverse/navigation/on_path.h>
#include <traverse/navigation/planner.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
Place placeOf(const PathPoint& point)
{
  return {point.pose.x_m, point.pose.y_m};
}

bool crossesHard(const Costmap& costmap, Place from, Place to)
{
  return !overCells(
      from, to, costmap.lattice,
      [&](geometry::CellIndex c, double) { return costmap.passageAt(c) < Passage::hard; });
}

bool isMiddleBlocked(const Costmap& costmap, const Plan& plan, const OnPath& here)
{
  Place from = here.nearest;
  for (size_t k = here.next; k < plan.path.size(); ++k)
  {
    const Place to = placeOf(plan.path[k]);
    if (plan.path[k].along_m > plan.way_out_m && crossesHard(costmap, from, to))
    {
      return true;
    }
    from = to;
  }
  return false;
}

bool isFootprintBlocked(
    const Costmap& costmap,
    const geometry::Vehicle& vehicle,
    const Plan& plan,
    size_t first,
    const geometry::Pose2& pose)
{
  Footprint footprint(vehicle);
  const auto now = footprint.cells(standAt(pose), costmap.lattice);
  const std::vector<RowSpan> stood_on(now.begin(), now.end());
  const auto hits = [&](const RowSpan& span)
  {
    for (int32_t x = span.first; x <= span.last; ++x)
    {
      if (costmap.passageAt({x, span.y}) == Passage::obstacle &&
          std::none_of(
              stood_on.begin(), stood_on.end(),
              [&](const RowSpan& s) { return s.y == span.y && s.first <= x && x <= s.last; }))
      {
        return true;
      }
    }
    return false;
  };
  for (size_t k = first; k < plan.path.size(); ++k)
  {
    const auto cells = footprint.cells(standAt(plan.path[k].pose), costmap.lattice);
    if (std::any_of(cells.begin(), cells.end(), hits))
    {
      return true;
    }
  }
  return false;
}
}  // namespace

Replan needsNewPlan(
    const Costmap& costmap,
    const geometry::Vehicle& vehicle,
    const Plan& plan,
    const geometry::Pose2& pose,
    const PlanParams& params)
{
  if (plan.path.empty())
  {
    return Replan::first;
  }
  const OnPath here = nearestOn(plan.path, {pose.x_m, pose.y_m});
  if (!(here.off_m <= params.stray_m))
  {
    return Replan::strayed;
  }
  if (isMiddleBlocked(costmap, plan, here) ||
      (plan.heeds_footprint && isFootprintBlocked(costmap, vehicle, plan, here.next, pose)))
  {
    return Replan::blocked;
  }
  const double length_m = plan.path.back().along_m;
  const double left_m = length_m - here.along_m;
  const bool is_near = left_m <= std::max(params.goal_tolerance_m, length_m / 4);
  return !plan.is_whole && is_near ? Replan::finished : Replan::no;
}
}  // namespace traverse::navigation
