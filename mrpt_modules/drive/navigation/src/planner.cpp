// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts.h"
#include "plan_ends.h"
#include "way_out.h"

#include <traverse/navigation/grid_path.h>
#include <traverse/navigation/hybrid_search.h>
#include <traverse/navigation/planner.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
constexpr double kStep_m = 0.1;

bool isUsable(Place place)
{
  return std::abs(place.x_m) <= geometry::kFarthest_m &&  // not NaN
         std::abs(place.y_m) <= geometry::kFarthest_m;
}

Plan none(std::string why_not)
{
  Plan plan;
  plan.why_not = std::move(why_not);
  return plan;
}

/** Nothing, or why nobody can be there. */
std::string hindranceAt(const Costmap& costmap, const Terrain& terrain, size_t index)
{
  switch (costmap.passageAt(terrain.cell(index)))
  {
    case Passage::obstacle:
      return "the goal lies in an obstacle";
    case Passage::hard:
      return "the goal lies in the hard buffer of an obstacle";
    default:
      return terrain.isOpen(index) ? "" : "the price of the goal's cell is no number";
  }
}

bool isHybrid(const PlanParams& params, const geometry::Drivetrain& drivetrain)
{
  return params.planner == PlannerKind::hybrid ||
         (params.planner == PlannerKind::fitting && geometry::minTurningRadius_m(drivetrain) > 0);
}

/** Throws options::OptionError. */
template <class Options>
const Options& checked(const Options& options)
{
  options::check(options);
  return options;
}
}  // namespace

class Planner::Impl
{
 public:
  Impl(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const PlanParams& params) :
      params_(checked(params)),
      is_hybrid_(isHybrid(params, checked(drivetrain))),
      attempts_(checked(vehicle), drivetrain, is_hybrid_, params.margin_m > 0),
      footprint_(vehicle),
      wide_footprint_(vehicle, params.margin_m),
      hybrid_(drivetrain, params)
  {
  }

  enum class Aim : uint8_t
  {
    at,    // the goal, or towards it where it is not known
    near,  // as near to the goal as is worth the way
  };

  Plan plan(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal, Aim aim)
  {
    const Place from = {start.x_m, start.y_m};
    const Place to = {goal.x_m, goal.y_m};
    if (!isUsable(from) || !std::isfinite(start.yaw_rad) || !isUsable(to) ||
        !std::isfinite(goal.yaw_rad.value_or(0)))
    {
      return none("start or goal is no place");
    }
    Plan way;
    for (const Attempt& attempt : attempts_.in(costmap))
    {
      attempt_ = attempt;
      way = planBy(costmap, start, goal, aim);
      if (!way.path.empty())
      {
        break;
      }
    }
    return way;
  }

 private:
  Plan planBy(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal, Aim aim)
  {
    const Place from = {start.x_m, start.y_m};
    const Place to = {goal.x_m, goal.y_m};
    terrain_.set(costmap);
    if (!terrain_.covers(from))
    {
      return none("the vehicle is outside the costmap");
    }
    terrain_.openBesideStrips(costmap, attempt_.beside_strip, attempt_.room);
    terrain_.openWayOut(costmap, cellOf(from, terrain_.lattice()), footprint_.radius_m());
    Plan plan;
    if (aim == Aim::near)
    {
      plan = planToOneOf(placesNear(costmap, terrain_, to, kNearness), costmap, start);
      plan = goesOn(plan) ? plan : none("it is as near to the goal as it can come");
    }
    else if (isWithin(costmap, to))
    {
      plan = planTo(costmap, start, goal);
    }
    else
    {
      plan = planToOneOf(endsOfTheKnown(costmap, terrain_, to), costmap, start);
    }
    plan.way_out_m = wayOut_m(costmap, plan.path);
    plan.heeds_footprint = is_hybrid_;
    return plan;
  }

  bool isWithin(const Costmap& costmap, Place to) const
  {
    return terrain_.covers(to) &&
           (costmap.is_unknown_planned ||
            costmap.passageAt(cellOf(to, terrain_.lattice())) != Passage::unknown);
  }

  Plan planTo(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal)
  {
    const geometry::CellIndex cell = cellOf({goal.x_m, goal.y_m}, terrain_.lattice());
    terrain_.openSoft(costmap, cell);
    const PriceField::Seed seed = {terrain_.indexOf(cell), 0};
    const std::string hindrance = hindranceAt(costmap, terrain_, seed.index);
    if (!hindrance.empty())
    {
      return none(hindrance);
    }
    field_.start(terrain_, {&seed, 1});
    if (!isReached(start))
    {
      return none("no way leads there");
    }
    Plan plan = is_hybrid_ ? byArcs(costmap, start, goal, 0) : overGround(start, goal);
    plan.is_whole = !plan.path.empty();
    return plan;
  }

  bool goesOn(const Plan& plan) const
  {
    return !plan.path.empty() &&
           geometry::distance_m(plan.path.front().pose, plan.path.back().pose) >
               params_.goal_tolerance_m;
  }

  Plan planToOneOf(
      std::span<const PriceField::Seed> ends, const Costmap& costmap, const geometry::Pose2& start)
  {
    field_.start(terrain_, ends);
    if (!isReached(start))
    {
      return none("no way leads out of what is known");
    }
    const Place end =
        downTheField(field_, terrain_, terrain_.indexAt({start.x_m, start.y_m})).back();
    if (!is_hybrid_)
    {
      return overGround(start, {end.x_m, end.y_m, {}});
    }
    constexpr double kLoose_m = 1.0;
    const PriceField::Seed seed = {terrain_.indexAt(end), 0};
    field_.start(terrain_, {&seed, 1});
    return byArcs(costmap, start, {end.x_m, end.y_m, {}}, kLoose_m);
  }

  bool isReached(const geometry::Pose2& start)
  {
    const size_t index = terrain_.indexAt({start.x_m, start.y_m});
    return field_.priceFrom(index) < PriceField::kNever;
  }

  /** Down the field to its seed, to the goal in its cell. */
  Plan overGround(const geometry::Pose2& start, const Goal& goal)
  {
    const Place from = {start.x_m, start.y_m};
    std::vector<Place> places = downTheField(field_, terrain_, terrain_.indexAt(from));
    places.insert(places.begin(), from);
    places.push_back({goal.x_m, goal.y_m});
    places = resampled(shortened(terrain_, places), kStep_m);
    smooth(terrain_, places);
    Plan plan;
    plan.price = priceOf(terrain_, places);
    plan.path = pathThrough(places, goal.yaw_rad);
    return plan;
  }

  /** `loose_m`: so far from the goal will do. */
  Plan byArcs(
      const Costmap& costmap, const geometry::Pose2& start, const Goal& goal, double loose_m)
  {
    Footprint& footprint = attempt_.is_wide ? wide_footprint_ : footprint_;
    obstacles_.set(costmap, footprint.cells(standAt(start), costmap.lattice));
    if (loose_m == 0 && !fitsAt(goal, footprint))
    {
      return none("the vehicle does not fit where the goal is");
    }
    HybridTask task;
    task.terrain = &terrain_;
    task.field = &field_;
    task.obstacles = &obstacles_;
    task.footprint = &footprint;
    task.start = start;
    task.goal = {goal.x_m, goal.y_m};
    task.yaw_rad = goal.yaw_rad;
    task.loose_m = loose_m;
    task.last_resort_m = params_.goal_tolerance_m / 2;
    task.most_expansions = params_.most_expansions / attempt_.share;
    Plan plan;
    plan.path = hybrid_.search(task);
    if (plan.path.empty())
    {
      return none(
          hybrid_.gaveUp() ? "no way was found within most_expansions"
                           : "the vehicle cannot turn or does not fit on the way there");
    }
    std::vector<Place> places;
    for (const PathPoint& point : plan.path)
    {
      places.push_back({point.pose.x_m, point.pose.y_m});
    }
    plan.price = priceOf(terrain_, places);
    return plan;
  }

  bool fitsAt(const Goal& goal, Footprint& footprint)
  {
    for (int k = 0; k < (goal.yaw_rad ? 1 : HeadingBins::kHeadings); ++k)
    {
      const double yaw_rad = goal.yaw_rad.value_or(2 * geometry::kPi * k / HeadingBins::kHeadings);
      if (!obstacles_.isHit(footprint, standAt({goal.x_m, goal.y_m, yaw_rad})))
      {
        return true;
      }
    }
    return false;
  }

  PlanParams params_;
  bool is_hybrid_;
  Attempts attempts_;
  Attempt attempt_;
  Footprint footprint_;
  Footprint wide_footprint_;
  Terrain terrain_;
  PriceField field_;
  ObstacleCounts obstacles_;
  HybridSearch hybrid_;
};

Planner::Planner(
    const geometry::Vehicle& vehicle,
    const geometry::Drivetrain& drivetrain,
    const PlanParams& params) :
    impl_(std::make_unique<Impl>(vehicle, drivetrain, params))
{
}

Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;
Planner& Planner::operator=(Planner&&) noexcept = default;

Plan Planner::plan(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal)
{
  return impl_->plan(costmap, start, goal, Impl::Aim::at);
}

Plan Planner::planNear(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal)
{
  return impl_->plan(costmap, start, goal, Impl::Aim::near);
}
}  // namespace traverse::navigation
