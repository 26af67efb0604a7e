// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/footprint.h>
#include <traverse/navigation/grid_path.h>
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

/** Where the last leg that touches a hard or an obstacle cell ends. */
double wayOut_m(const Costmap& costmap, const Path& path)
{
  const auto is_passed = [&](geometry::CellIndex c, double)
  { return costmap.passageAt(c) < Passage::hard; };
  for (size_t k = path.size(); k-- > 1;)
  {
    const geometry::Pose2& a = path[k - 1].pose;
    const geometry::Pose2& b = path[k].pose;
    if (!overCells({a.x_m, a.y_m}, {b.x_m, b.y_m}, costmap.lattice, is_passed))
    {
      return path[k].along_m;
    }
  }
  return 0;
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
}  // namespace

class Planner::Impl
{
 public:
  Impl(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const PlanParams& params) :
      vehicle_(vehicle), drivetrain_(drivetrain), params_(params), footprint_(vehicle)
  {
    options::check(vehicle);
    options::check(drivetrain);
    options::check(params);
  }

  Plan plan(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal)
  {
    const Place from = {start.x_m, start.y_m};
    const Place to = {goal.x_m, goal.y_m};
    if (!isUsable(from) || !std::isfinite(start.yaw_rad) || !isUsable(to) ||
        !std::isfinite(goal.yaw_rad.value_or(0)))
    {
      return none("start or goal is no place");
    }
    terrain_.set(costmap);
    if (!terrain_.covers(from))
    {
      return none("the vehicle is outside the costmap");
    }
    terrain_.openWayOut(costmap, cellOf(from, terrain_.lattice()), footprint_.radius_m());
    Plan plan =
        isWithin(costmap, to) ? planTo(costmap, start, goal) : planTowards(costmap, start, to);
    plan.way_out_m = wayOut_m(costmap, plan.path);
    return plan;
  }

 private:
  /** The goal can be planned to, as far as its cell is concerned. */
  bool isWithin(const Costmap& costmap, Place to) const
  {
    return terrain_.covers(to) &&
           (costmap.is_unknown_planned ||
            costmap.passageAt(cellOf(to, terrain_.lattice())) != Passage::unknown);
  }

  Plan planTo(const Costmap& costmap, const geometry::Pose2& start, const Goal& goal)
  {
    const Place to = {goal.x_m, goal.y_m};
    const geometry::CellIndex cell = cellOf(to, terrain_.lattice());
    terrain_.openSoft(costmap, cell);
    const std::string hindrance = hindranceAt(costmap, terrain_, terrain_.indexOf(cell));
    if (!hindrance.empty())
    {
      return none(hindrance);
    }
    const PriceField::Seed seed = {terrain_.indexOf(cell), 0};
    field_.start(terrain_, {&seed, 1});
    Plan plan = follow(start, to, goal.yaw_rad);
    plan.is_whole = !plan.path.empty();
    return plan;
  }

  /** Where the known ends: at the border, and at unknown cells that are not planned through. */
  Plan planTowards(const Costmap& costmap, const geometry::Pose2& start, Place to)
  {
    std::vector<PriceField::Seed> seeds;
    const geometry::CellRect& extent = costmap.extent;
    const auto is_beyond = [&](int32_t x, int32_t y)
    {
      return !extent.contains({x, y}) ||
             (!costmap.is_unknown_planned && costmap.passageAt({x, y}) == Passage::unknown);
    };
    for (int32_t y = extent.min.y; y < extent.max.y; ++y)
    {
      for (int32_t x = extent.min.x; x < extent.max.x; ++x)
      {
        const size_t index = terrain_.indexOf({x, y});
        if (terrain_.isOpen(index) && (is_beyond(x - 1, y) || is_beyond(x + 1, y) ||
                                       is_beyond(x, y - 1) || is_beyond(x, y + 1)))
        {
          const Place place = terrain_.centre(index);
          const double dx = to.x_m - place.x_m;
          const double dy = to.y_m - place.y_m;
          seeds.push_back({index, std::sqrt(dx * dx + dy * dy) * terrain_.mean()});
        }
      }
    }
    field_.start(terrain_, seeds);
    return follow(start, {}, {});
  }

  /** Down the field to its seed, or to a place in the seed's cell. */
  Plan follow(const geometry::Pose2& start, std::optional<Place> end, std::optional<double> yaw_rad)
  {
    const Place from = {start.x_m, start.y_m};
    const size_t index = terrain_.indexAt(from);
    if (!(field_.priceFrom(index) < PriceField::kNever))
    {
      return none("no way leads there");
    }
    std::vector<Place> places = downTheField(field_, terrain_, index);
    places.insert(places.begin(), from);
    places.push_back(end.value_or(places.back()));
    places = resampled(shortened(terrain_, places), kStep_m);
    smooth(terrain_, places);
    Plan plan;
    plan.price = priceOf(terrain_, places);
    plan.path = pathThrough(places, yaw_rad);
    return plan;
  }

  geometry::Vehicle vehicle_;
  geometry::Drivetrain drivetrain_;
  PlanParams params_;
  Footprint footprint_;
  Terrain terrain_;
  PriceField field_;
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
  return impl_->plan(costmap, start, goal);
}
}  // namespace traverse::navigation
