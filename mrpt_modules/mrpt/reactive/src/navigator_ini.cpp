// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "navigator_ini.h"

#include <traverse/geometry/exact_trig.h>

#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace traverse::reactive
{
namespace
{
using geometry::Drivetrain;
using geometry::Steering;
using geometry::Vehicle;

// More cells than these in one collision grid are a slip of the pen: about a gigabyte.
constexpr double kMostCells = 4e6;

/** A family of trajectories: a class of MRPT's, its own keys, and whether it drives backward. */
struct Family
{
  std::string_view type;
  std::string_view keys;
  double priority = 1;
  bool needs_reverse = false;
};

// C (arcs) stands in each list as it reaches nearly all places; alpha turns almost on the spot,
// which a car cannot. Without CCS, CC and CS a car stops 4 times in 10 before what it could pass.
constexpr Family kDifferential[] = {
    {"CPTG_DiffDrive_C", "K = 1.0\n", 1.0, false},
    {"CPTG_DiffDrive_alpha", "cte_a0v_deg = 57\ncte_a0w_deg = 57\n", 1.0, false},
    {"CPTG_DiffDrive_C", "K = -1.0\n", 0.5, true}};
constexpr Family kAckermann[] = {
    {"CPTG_DiffDrive_C", "K = 1.0\n", 1.0, false},
    {"CPTG_DiffDrive_C", "K = -1.0\n", 0.5, true},
    {"CPTG_DiffDrive_CCS", "K = 1.0\n", 0.8, true},
    {"CPTG_DiffDrive_CC", "K = 1.0\n", 0.8, true},
    {"CPTG_DiffDrive_CS", "K = 1.0\n", 0.8, false}};

void checkAll(const Vehicle& vehicle, const Drivetrain& drivetrain, const ReactiveParams& params)
{
  options::check(vehicle);
  options::check(drivetrain);
  options::check(params);
  const auto& xs = vehicle.footprint_xs_m;
  if (xs.size() < 3 || xs.size() != vehicle.footprint_ys_m.size())
  {
    throw options::OptionError(
        "footprint_xs_m", options::format(xs), "3 corners or more, and as many in footprint_ys_m");
  }
  for (const auto* values : {&xs, &vehicle.footprint_ys_m})
  {
    for (const double value : *values)
    {
      options::check({"footprint_xs_m", "", {-50, 50}}, value);
    }
  }
  const double cells = 2 * params.reference_distance_m / params.grid_resolution_m;
  if (cells * cells > kMostCells)
  {
    throw options::OptionError(
        "grid_resolution_m", options::format(params.grid_resolution_m),
        fmt::format(
            "{} or more with reference_distance_m = {}",
            2 * params.reference_distance_m / std::sqrt(kMostCells), params.reference_distance_m));
  }
}

std::string optimizer()
{
  return R"([CMultiObjectiveMotionOptimizerBase]
score1_name = target_distance
score1_formula = var d := max(0,target_d_norm-move_cur_d); if(collision_free_distance>d, 1/(1+d^2), 0)
score2_name = colfree
score2_formula = var d := max(0,target_d_norm-move_cur_d); if(collision_free_distance>(d+0.05), 1.0, collision_free_distance)
score3_name = euclidean_nearness
score3_formula = 1/(1+dist_eucl_min^2)
score4_name = ptg_priority_score
score4_formula = ptg_priority

[CMultiObjMotionOpt_Scalarization]
scalar_score_formula = ptg_priority_score*(0.3*target_distance + 0.5*colfree + 8.0*euclidean_nearness)

)";
}

/** The key's lines, each with the family's prefix. */
std::string prefixed(std::string_view prefix, std::string_view lines)
{
  std::string text;
  while (!lines.empty())
  {
    const size_t end = lines.find('\n') + 1;
    text += fmt::format("{}{}", prefix, lines.substr(0, end));
    lines.remove_prefix(end);
  }
  return text;
}

template <size_t N>
std::string families(
    const Family (&all)[N], int first, const Drivetrain& drivetrain, const ReactiveParams& params)
{
  std::string text;
  int n = 0;
  for (const Family& family : all)
  {
    if (family.needs_reverse && drivetrain.max_reverse_mps <= 0)
    {
      continue;
    }
    const std::string lines = fmt::format(
        "Type = {}\nresolution = {}\nrefDistance = {}\nnum_paths = {}\nv_max_mps = {}\n"
        "w_max_dps = {}\nscore_priority = {}\n{}",
        family.type, params.grid_resolution_m, params.reference_distance_m, params.paths,
        drivetrain.max_speed_mps, fullTurnDegps(drivetrain), family.priority, family.keys);
    text += prefixed(fmt::format("PTG{}_", first + n), lines);
    ++n;
  }
  return fmt::format("PTG_COUNT = {}\n{}", n, text);
}

std::string familiesOf(const Drivetrain& drivetrain, int first, const ReactiveParams& params)
{
  return drivetrain.steering == Steering::ackermann
             ? families(kAckermann, first, drivetrain, params)
             : families(kDifferential, first, drivetrain, params);
}

std::string shapeFlat(const Vehicle& vehicle)
{
  return fmt::format(
      "[CReactiveNavigationSystem]\nmin_obstacles_height = 0\nmax_obstacles_height = {}\n"
      "RobotModel_shape2D_xs = {}\nRobotModel_shape2D_ys = {}\n",
      vehicle.height_m, options::format(vehicle.footprint_xs_m),
      options::format(vehicle.footprint_ys_m));
}

/** Two prisms of one outline: [Vehicle] has no other. */
std::string shapeLevels(const Vehicle& vehicle)
{
  std::string text = fmt::format(
      "[CReactiveNavigationSystem3D]\nmin_obstacles_height = 0\nmax_obstacles_height = {}\n"
      "HEIGHT_LEVELS = 2\n",
      vehicle.height_m);
  for (const int level : {1, 2})
  {
    text += fmt::format(
        "LEVEL{0}_HEIGHT = {1}\nLEVEL{0}_VECTORX = {2}\nLEVEL{0}_VECTORY = {3}\n", level,
        vehicle.height_m / 2, options::format(vehicle.footprint_xs_m),
        options::format(vehicle.footprint_ys_m));
  }
  return text;
}
}  // namespace

double fullTurnDegps(const Drivetrain& drivetrain)
{
  const double radius_m = geometry::minTurningRadius_m(drivetrain);
  return drivetrain.steering == Steering::ackermann
             ? drivetrain.max_speed_mps / radius_m * 180 / geometry::kPi
             : drivetrain.max_yaw_rate_degps;
}

std::string navigatorIni(
    const Vehicle& vehicle, const Drivetrain& drivetrain, const ReactiveParams& params)
{
  checkAll(vehicle, drivetrain, params);
  const bool is_flat = params.navigator == Navigator::flat;
  return fmt::format(
             "[CAbstractNavigator]\nalarm_seems_not_approaching_target_timeout = 30\n\n"
             "[CAbstractPTGBasedReactive]\nrobotMax_V_mps = {}\nrobotMax_W_degps = {}\n"
             "holonomic_method = CHolonomicND\n"
             "motion_decider_method = CMultiObjMotionOpt_Scalarization\nref_distance = {}\n"
             "enable_obstacle_filtering = false\n\n"
             "[CHolonomicND]\nfactorWeights = 1.00 0.50 2.00 0.40\n\n",
             drivetrain.max_speed_mps, fullTurnDegps(drivetrain), params.reference_distance_m) +
         optimizer() + (is_flat ? shapeFlat(vehicle) : shapeLevels(vehicle)) +
         familiesOf(drivetrain, is_flat ? 0 : 1, params);
}
}  // namespace traverse::reactive
