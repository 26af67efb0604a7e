// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace traverse::app
{
namespace
{
using navigation::Conduct;

Json latenciesOf(const Latencies& latencies)
{
  Json all;
  for (size_t i = 0; i < kStageNames.size(); ++i)
  {
    const auto stage = static_cast<Stage>(i);
    all[std::string(kStageNames[i])] = {
        {"count", latencies.count(stage)},
        {"p50_ms", latencies.percentileMs(stage, 0.5)},
        {"p95_ms", latencies.percentileMs(stage, 0.95)},
        {"p99_ms", latencies.percentileMs(stage, 0.99)},
        {"most_ms", latencies.percentileMs(stage, 1)}};
  }
  return all;
}

Json plansOf(const Pilot& pilot)
{
  const auto& plans = pilot.plans();
  return {
      {"first", plans[static_cast<size_t>(navigation::Replan::first)]},
      {"blocked", plans[static_cast<size_t>(navigation::Replan::blocked)]},
      {"strayed", plans[static_cast<size_t>(navigation::Replan::strayed)]},
      {"finished", plans[static_cast<size_t>(navigation::Replan::finished)]}};
}

/** How often the pilot planned, how long its stages took, what maps and control take of a core, and
 * how many control steps take longer than a period. */
void addWork(Json& json, const NavSettings& settings, const Pilot& pilot, double time_s)
{
  const Latencies& latencies = pilot.latencies();
  json["plans"] = plansOf(pilot);
  json["latencies"] = latenciesOf(latencies);
  constexpr double kMsPerS = 1000;
  const double busy_ms = latencies.totalMs(Stage::maps) + latencies.totalMs(Stage::control);
  json["core_share"] = busy_ms / (kMsPerS * std::max(time_s, 1e-9));
  json["late_control_share"] =
      latencies.shareAbove(Stage::control, kMsPerS / settings.run.control_hz);
}

/** Shares of the control steps by what the pilot did. */
Json sharesOf(const DriveResult& result)
{
  Json shares;
  for (const Conduct conduct :
       {Conduct::drive, Conduct::stop, Conduct::recover, Conduct::give_up, Conduct::arrived})
  {
    double count = 0;
    for (const DriveRecord& record : result.records)
    {
      count += record.pilot.conduct == conduct ? 1 : 0;
    }
    const auto all = static_cast<double>(std::max<size_t>(1, result.records.size()));
    shares[std::string(nameOf(conduct))] = count / all;
  }
  return shares;
}

/** Commands beside what was driven, where both move. */
Json agreementOf(const DriveResult& result)
{
  constexpr double kMoves_mps = 0.05;
  double driven = 0, commanded = 0;
  std::vector<double> off_1pm;
  for (const DriveRecord& record : result.records)
  {
    const geometry::Twist2& was = record.vehicle.twist;
    const geometry::Twist2& would_be = record.pilot.command;
    if (std::abs(was.speed_mps) < kMoves_mps || std::abs(would_be.speed_mps) < kMoves_mps)
    {
      continue;
    }
    const double curvature = would_be.yaw_rate_radps / would_be.speed_mps;
    off_1pm.push_back(std::abs(curvature - was.yaw_rate_radps / was.speed_mps));
    driven += was.speed_mps;
    commanded += would_be.speed_mps;
  }
  if (off_1pm.empty())
  {
    return {{"share", 0}};
  }
  const auto count = static_cast<double>(off_1pm.size());
  const auto middle = off_1pm.begin() + static_cast<std::ptrdiff_t>(off_1pm.size() / 2);
  std::nth_element(off_1pm.begin(), middle, off_1pm.end());
  return {
      {"share", count / static_cast<double>(result.records.size())},
      {"driven_mean_mps", driven / count},
      {"commanded_mean_mps", commanded / count},
      {"curvature_median_difference_1pm", *middle}};
}
}  // namespace

Json driveMetrics(
    const NavSettings& settings,
    const Pilot& pilot,
    const DriveResult& result,
    double optimum_m,
    uint64_t seed)
{
  const double shortest_s = optimum_m / settings.drivetrain.max_speed_mps;
  Json json;
  json["title"] = settings.run.title;
  json["scene"] = settings.scene.filename().string();
  json["seed"] = seed;
  json["reached"] = result.reached;
  json["end"] = result.end;
  json["goals_reached"] = result.goals_reached;
  json["collisions"] = result.collisions;
  json["struck_standing"] = result.struck_standing;
  json["min_clearance_m"] = result.min_clearance_m;
  json["time_s"] = result.time_s;
  json["way_m"] = result.way_m;
  json["optimum_m"] = std::isfinite(optimum_m) ? Json(optimum_m) : Json();
  json["time_over_optimum"] =
      result.reached && std::isfinite(optimum_m) ? Json(result.time_s / shortest_s) : Json();
  json["stops"] = result.stops;
  json["slips"] = result.slips;
  addWork(json, settings, pilot, result.time_s);
  return json;
}

Json replayMetrics(
    const NavSettings& settings,
    const Pilot& pilot,
    const ReplayResult& result,
    const std::filesystem::path& log)
{
  Json json;
  json["title"] = settings.run.title;
  json["log"] = log.filename().string();
  json["end"] = result.end;
  json["problem"] = result.problem.empty() ? Json() : Json(result.problem);
  json["time_s"] = result.time_s;
  json["way_m"] = result.way_m;
  json["stops"] = result.stops;
  json["scans"] = result.scans;
  json["scans_without_pose"] = result.scans_without_pose;
  json["off_track_s"] = result.off_track_s;
  json["driven_into_obstacles"] = result.collisions;
  json["stood_in_obstacles"] = result.struck_standing;
  json["min_clearance_m"] = result.min_clearance_m;
  json["conduct"] = sharesOf(result);
  json["both_move"] = agreementOf(result);
  addWork(json, settings, pilot, result.time_s);
  return json;
}
}  // namespace traverse::app
