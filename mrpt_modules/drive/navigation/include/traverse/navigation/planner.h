// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/navigation/costmap.h>
#include <traverse/navigation/path.h>
#include <traverse/navigation/plan_params.h>

#include <memory>
#include <optional>
#include <string>

namespace traverse::navigation
{
/** Where to go. */
struct Goal
{
  double x_m = 0;
  double y_m = 0;
  std::optional<double> yaw_rad;  //!< nothing: any heading will do
};

/** A way, or why there is none. */
struct Plan
{
  Path path;              //!< empty: there is none
  double price = 0;       //!< sum of metres times price (kLeastPrice) along it
  double way_out_m = 0;   //!< so much of its beginning leads out of hard cells
  bool is_whole = false;  //!< it ends at the goal; otherwise where the known ends on the way there
  bool heeds_footprint = false;  //!< the whole footprint keeps off obstacle cells (hybrid)
  std::string why_not;           //!< for people, where there is no path
};

/** Plans in a costmap. Keeps its memory from one plan to the next.
 *
 * First a field of prices is grown from the goal (Dijkstra over 8 neighbours, stopped once the
 * start is settled); a vehicle that turns on the spot follows it down, and the path is then
 * shortened wherever the straight line costs no more. For a car-like vehicle the field leads a
 * search over (x, y, heading) with arcs that it can drive (hybrid A*, Dolgov et al. 2010), which
 * tries Reeds-Shepp curves to the goal (OMPL) as it comes near; its footprint is held against
 * obstacle cells along every arc, with PlanParams::margin_m where there is a way so.
 *
 * Obstacle and hard cells are never passed; soft ones, at CostParams::soft_price, where the start
 * or the goal lies in one, to get out or in; up to 2 cells beside strips by car-like vehicles; and
 * up to 5 beside strips where there is no way otherwise (seen from within, they have gaps). Cars
 * try without strips that are narrower than their front swings out first. A vehicle that stands in
 * hard cells is led away from what they surround, and obstacle cells under it where it stands are
 * no hindrance: noise must not hold it for good. A goal outside the costmap, or in unknown cells
 * that are not planned through, is replaced by the cell of the border, or beside such unknown
 * cells, from which the way there plus the straight line beyond is cheapest (is_whole = false). */
class Planner
{
 public:
  /** Throws options::OptionError. */
  Planner(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const PlanParams& params);
  ~Planner();
  Planner(Planner&&) noexcept;
  Planner& operator=(Planner&&) noexcept;

  Plan plan(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal);

  /** As near to a goal as is worth the way: from far off ground may look blocked that is not, and
   * is to be looked at from there. A metre nearer is worth kNearness of way. Never whole; without a
   * path where the vehicle should stay within PlanParams::goal_tolerance_m of where it is. */
  Plan planNear(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal);

  static constexpr double kNearness = 5;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/** Why a path is left for a new one. */
enum class Replan : uint8_t
{
  no,
  first,     //!< there is none yet, or it belongs to another goal
  blocked,   //!< it crosses a hard buffer or an obstacle ahead (and not, if it clips a soft one)
  strayed,   //!< the vehicle is further than PlanParams::stray_m from it
  finished,  //!< it ends before the goal, and no more than its last quarter is left
};

/** Spec 5: a path that only clips soft buffers is kept. Looks at what is ahead of `pose`, as far as
 * the costmap reaches: at hard and obstacle cells under the vehicle's middle (but for
 * Plan::way_out_m) and, where the plan heeds it, at obstacle cells under its footprint (but for
 * those under it at `pose`). That the goal is another one, the caller knows. */
Replan needsNewPlan(
    const Costmap& costmap,
    const geometry::Vehicle& vehicle,
    const Plan& plan,
    const geometry::Pose2& pose,
    const PlanParams& params);
}  // namespace traverse::navigation
