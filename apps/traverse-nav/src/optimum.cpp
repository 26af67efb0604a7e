// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/nav_app/closed_loop.h>
#include <traverse/simulation/truth.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::app
{
namespace
{
/** The truth as a map of the planner: its classes are those of a traversability map. */
layers::LayerSet asMap(layers::LayerSet truth)
{
  for (layers::Layer& layer : truth.layers)
  {
    layer.name = layer.name == "truth_class" ? "traversability_class" : layer.name;
  }
  return truth;
}

/** Buffers and prices would make longer ways better ones. */
navigation::CostParams plainCosts(const NavSettings& settings)
{
  navigation::CostParams costs = settings.costs;
  costs.soft_buffer_m = 0;
  costs.index_price = 0;
  costs.slope_price = 0;
  return costs;
}
}  // namespace

double optimum_m(const NavSettings& settings, const Mission& mission)
{
  simulation::TruthParams params;
  params.cell_size_m = settings.costs.cell_size_m;
  simulation::Scene still = mission.scene;
  std::erase_if(
      still.objects, [](const simulation::Object& object) { return object.motion.moves(); });
  const geometry::Vehicle& vehicle = settings.robot.vehicle;
  const layers::LayerSet truth = asMap(
      simulation::cellTruth(still, vehicle, params, 0, {mission.start.x_m, mission.start.y_m}));
  const navigation::MapLayers map{"truth", &truth};
  const navigation::Costmap costmap = navigation::costmapOf(
      {&map, 1}, truth.lattice, truth.extent, mission.start, vehicle, plainCosts(settings));
  navigation::PlanParams plan = settings.plan;
  plan.planner = navigation::PlannerKind::grid;
  navigation::Planner planner(vehicle, settings.drivetrain, plan);
  double length_m = 0;
  geometry::Pose2 from = mission.start;
  for (const navigation::Goal& goal : mission.goals)
  {
    const navigation::Plan leg = planner.plan(costmap, from, goal);
    if (leg.path.empty() || !leg.is_whole)
    {
      return std::numeric_limits<double>::quiet_NaN();
    }
    length_m += leg.path.back().along_m;
    from = {goal.x_m, goal.y_m, 0};
  }
  return length_m;
}
}  // namespace traverse::app
