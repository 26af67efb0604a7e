// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// ./run experiment navigation [--quick] [--seeds A-B]: drives in simulated worlds, two vehicles in
// each, poses exact; the first fifth of the seeds again with odometry and ICP. Keys:
// WORLD_VEHICLE_reached (share), _collisions (sum), _struck_standing, _min_clearance_m,
// _time_over_optimum (mean of those that arrived), _stops (mean); the same with icp_ before. With
// --quick: seeds 101-110.
#include <traverse/geometry/exact_trig.h>
#include <traverse/nav_app/closed_loop.h>
#include <traverse/plugin/register.h>
#include <traverse/simulation/ray_caster.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <support/experiment.h>
#include <support/process.h>
#include <support/seed_runs.h>
#include <vector>

namespace
{
using namespace traverse;
using namespace traverse::testing;

const std::vector<std::string> kWorlds = {"clutter", "park", "tunnel", "warehouse", "icy_lot"};
std::filesystem::path own_program;  // NOLINT: set once, by main()
const std::vector<std::string> kVehicles = {"differential", "ackermann"};

/** One drive to make. */
struct Drive
{
  std::string world;
  std::string vehicle;
  std::string strip;  //!< [Costmap] strip
  std::string poses;  //!< [traverse-nav] poses
};

/** How far from the middle between what is on the left and on the right the vehicle drove, m, 95 %
 * of the places with both nearer than 2 m (at half a metre of height); NaN where there is none. */
double offMiddle_m(const simulation::Scene& scene, const app::DriveResult& result)
{
  constexpr double kNear_m = 2;
  const simulation::RayCaster caster(scene);
  std::vector<double> off_m;
  for (const app::DriveRecord& record : result.records)
  {
    const geometry::Pose2& pose = record.vehicle.pose;
    const geometry::SinCos turn = geometry::sinCosOfAny(pose.yaw_rad);
    const double ground_m = scene.terrain->at(pose.x_m, pose.y_m).height_m;
    const Eigen::Vector3d from(pose.x_m, pose.y_m, ground_m + 0.5);
    const auto free_m = [&](double side)
    {
      const Eigen::Vector3d to(-turn.sin * side, turn.cos * side, 0);
      return caster.cast({from, to, record.t_s}, kNear_m).range_m;
    };
    const double left_m = free_m(1);
    const double right_m = free_m(-1);
    if (left_m < kNear_m && right_m < kNear_m)
    {
      off_m.push_back(std::abs(left_m - right_m) / 2);
    }
  }
  std::sort(off_m.begin(), off_m.end());
  return off_m.empty() ? std::numeric_limits<double>::quiet_NaN()
                       : off_m[(off_m.size() - 1) * 95 / 100];
}

nlohmann::json driven(const Drive& what, uint64_t seed)
{
  const std::filesystem::path ini =
      std::filesystem::path(TRAVERSE_SOURCE_DIR) / "ini" / ("nav_" + what.vehicle + ".ini");
  const app::NavSettings settings = app::readNavSettings(
      ini, {"traverse-nav.scene=scenes/" + what.world + ".ini", "traverse-nav.poses=" + what.poses,
            "Costmap.strip=" + what.strip});
  const app::Mission mission = app::readMission(settings, seed);
  app::Pilot pilot(settings, std::filesystem::temp_directory_path() / "traverse-collision-grids");
  const app::DriveResult result = app::drive(settings, mission, seed, pilot, {});
  const double best_m = app::optimum_m(settings, mission);
  return {
      {"reached", result.reached},
      {"solvable", std::isfinite(best_m)},
      {"collisions", result.collisions},
      {"struck_standing", result.struck_standing},
      {"min_clearance_m", result.min_clearance_m},
      {"off_middle_m", offMiddle_m(mission.scene, result)},
      {"stops", result.stops},
      {"time_over_optimum", result.time_s * settings.drivetrain.max_speed_mps / best_m},
      {"control_p95_ms", pilot.latencies().percentileMs(app::Stage::control, 0.95)},
      {"maps_p95_ms", pilot.latencies().percentileMs(app::Stage::maps, 0.95)},
      {"end", result.end}};
}

/** A drive in a process of its own: MRPT's clock is one for a process. */
nlohmann::json drivenApart(const Drive& what, uint64_t seed)
{
  const Finished child = traverse::testing::run(
      {own_program.string(), "--one", what.world, what.vehicle, what.strip, what.poses,
       std::to_string(seed)},
      {}, std::chrono::seconds(1800));
  if (child.exit_code != 0)
  {
    throw std::runtime_error(
        what.world + " " + what.vehicle + " " + std::to_string(seed) + ": " + child.err);
  }
  return nlohmann::json::parse(child.out);
}

nlohmann::json driveAll(uint64_t seed, const std::string& poses)
{
  nlohmann::json all;
  const auto add = [&](const std::string& key, const Drive& what)
  {
    all[key] = drivenApart(what, seed);
    if (!all[key]["reached"] || all[key]["collisions"] != 0)
    {
      std::cerr << "seed " << seed << " " << poses << " " << key << ": " << all[key].dump() << "\n";
    }
  };
  for (const std::string& vehicle : kVehicles)
  {
    for (const std::string& world : kWorlds)
    {
      add(world + "_" + vehicle, {world, vehicle, "default", poses});
    }
    if (poses == "exact")
    {
      add("tunnel_no_strip_" + vehicle, {"tunnel", vehicle, "none", poses});
    }
  }
  return all;
}

double sumOf(const std::vector<nlohmann::json>& runs, const std::string& key, const char* what)
{
  double sum = 0;
  for (const nlohmann::json& one : runs)
  {
    const nlohmann::json& value = one[key][what];
    sum += value.is_boolean() ? static_cast<double>(value.get<bool>()) : value.get<double>();
  }
  return sum;
}

/** NaN where none arrived. */
double meanWhereReached(
    const std::vector<nlohmann::json>& runs, const std::string& key, const char* what)
{
  double sum = 0;
  int count = 0;
  for (const nlohmann::json& one : runs)
  {
    if (one[key]["reached"] && one[key][what].is_number())
    {
      sum += one[key][what].get<double>();
      ++count;
    }
  }
  return count == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / count;
}

void tell(
    const std::string& prefix,
    const std::vector<nlohmann::json>& runs,
    nlohmann::ordered_json& figures)
{
  const auto count = static_cast<double>(runs.size());
  for (const auto& [key, first] : runs.front().items())
  {
    if (!first.is_object())
    {
      continue;
    }
    const std::string name = prefix + key;
    double nearest = std::numeric_limits<double>::infinity();
    for (const nlohmann::json& one : runs)
    {
      nearest = std::min(nearest, one[key]["min_clearance_m"].get<double>());
    }
    figures[name + "_reached"] = sumOf(runs, key, "reached") / count;
    figures[name + "_solvable"] = sumOf(runs, key, "solvable") / count;
    figures[name + "_collisions"] = sumOf(runs, key, "collisions");
    figures[name + "_struck_standing"] = sumOf(runs, key, "struck_standing");
    figures[name + "_min_clearance_m"] = nearest;
    figures[name + "_time_over_optimum"] = meanWhereReached(runs, key, "time_over_optimum");
    figures[name + "_off_middle_m"] = meanWhereReached(runs, key, "off_middle_m");
    figures[name + "_stops"] = sumOf(runs, key, "stops") / count;
    figures[name + "_control_p95_ms"] = sumOf(runs, key, "control_p95_ms") / count;
  }
}

int runAll(const std::vector<std::string>& args)
{
  if (args.size() == 6 && args[0] == "--one")
  {
    plugin::registerAllMaps();
    std::cout << driven({args[1], args[2], args[3], args[4]}, std::stoull(args[5])).dump() << "\n";
    return 0;
  }
  const SeedOptions options = seedOptions(args, {101, 150, ""});
  const auto exact = runSeeds(options, [](uint64_t seed) { return driveAll(seed, "exact"); });
  SeedOptions few = options;
  few.last = options.first + (options.last - options.first) / 5;
  few.resume += few.resume.empty() ? "" : "_icp";
  const auto icp = runSeeds(few, [](uint64_t seed) { return driveAll(seed, "icp_3d"); });
  nlohmann::ordered_json figures;
  tell("", exact, figures);
  tell("icp_", icp, figures);
  figures["seeds"] = std::to_string(options.first) + "-" + std::to_string(options.last);
  print(figures);
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  return traverse::testing::reported(
      "navigation",
      [&]
      {
        own_program = std::filesystem::read_symlink("/proc/self/exe");
        return runAll({argv + 1, argv + argc});
      });
}
