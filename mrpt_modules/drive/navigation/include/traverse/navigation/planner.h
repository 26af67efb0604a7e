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
  Path path;         //!< empty: there is none
  double price = 0;  //!< sum of metres times price (kLeastPrice) along it
  bool is_whole =
      false;            //!< it ends at the goal; otherwise at the window's border on the way there
  std::string why_not;  //!< for people, where there is no path
};

/** Plans in a costmap. Keeps its memory from one plan to the next.
 *
 * First a field of prices is grown from the goal (Dijkstra over 8 neighbours, stopped once the
 * start is settled); a vehicle that turns on the spot follows it down, and the path is then
 * shortened wherever the straight line costs no more. For a car-like vehicle the field leads a
 * search over (x, y, heading) with arcs that it can drive (hybrid A*, Dolgov et al. 2010), which
 * tries Reeds-Shepp curves to the goal (OMPL) as it comes near; its footprint is held against
 * obstacle cells along every arc.
 *
 * Obstacle and hard cells are never passed; soft ones only where the start or the goal lies in one,
 * at CostParams::soft_price, to get out or in. A goal outside the costmap is replaced by the
 * cheapest cell of the border towards it (is_whole = false). */
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
  finished,  //!< it ended before the goal, and the vehicle is near its end
};

/** Spec 5: a path that only clips soft buffers is kept. Looks at what is ahead of `pose`, as far as
 * the costmap reaches; of a car-like vehicle's path, at hard cells under its middle and obstacle
 * cells under its footprint. */
Replan needsNewPlan(
    const Costmap& costmap,
    const geometry::Vehicle& vehicle,
    const Plan& plan,
    const geometry::Pose2& pose,
    const PlanParams& params);
}  // namespace traverse::navigation
