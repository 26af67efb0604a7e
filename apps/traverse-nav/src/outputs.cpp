// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "report_page.h"

#include <traverse/formats/trajectory.h>
#include <traverse/nav_app/picture.h>
#include <traverse/poses/level_pose.h>
#include <traverse/simulation/lidar.h>

#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
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

std::string trajectory(const DriveResult& result)
{
  std::vector<poses::StampedPose> poses;
  for (const DriveRecord& record : result.records)
  {
    poses.push_back(
        {poses::later(simulation::kRecordingStart, record.t_s),
         poses::levelPose(record.vehicle.pose)});
  }
  return formats::tumTrajectory(poses);
}

std::string table(const DriveResult& result)
{
  std::string text =
      "t_s,x_m,y_m,yaw_rad,speed_mps,yaw_rate_radps,believed_x_m,believed_y_m,command_mps,"
      "command_radps,limit_mps,limited_by,conduct,cause,clearance_m,slips\n";
  for (const DriveRecord& r : result.records)
  {
    const simulation::VehicleState& v = r.vehicle;
    text += fmt::format(
        "{:.3f},{:.4f},{:.4f},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f},", r.t_s, v.pose.x_m, v.pose.y_m,
        v.pose.yaw_rad, v.twist.speed_mps, v.twist.yaw_rate_radps, r.believed.x_m, r.believed.y_m);
    text += fmt::format(
        "{:.4f},{:.4f},{:.4f},{},{},{},{:.3f},{}\n", r.pilot.command.speed_mps,
        r.pilot.command.yaw_rate_radps, r.pilot.speed_limit_mps, nameOf(r.pilot.limited_by),
        nameOf(r.pilot.conduct), nameOf(r.pilot.cause), r.clearance_m, v.slips ? 1 : 0);
  }
  return text;
}

std::string decisionTable(const Pilot& pilot)
{
  std::string text = "t_s,conduct,cause,text\n";
  for (const navigation::Decision& decision : pilot.decisions())
  {
    text += fmt::format(
        "{:.3f},{},{},\"{}\"\n", poses::secondsBetween(simulation::kRecordingStart, decision.time),
        nameOf(decision.conduct), nameOf(decision.cause), decision.text);
  }
  return text;
}
}  // namespace

Json metricsOf(
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
  json["plans"] = plansOf(pilot);
  json["latencies"] = latenciesOf(pilot.latencies());
  return json;
}

void writeDrive(
    formats::OutputFolder& folder,
    const NavSettings& settings,
    const Pilot& pilot,
    const Mission& mission,
    const DriveResult& result,
    const Json& metrics)
{
  folder.write("trajectory.tum", trajectory(result));
  folder.write("drive.csv", table(result));
  folder.write("decisions.csv", decisionTable(pilot));
  for (const BuiltMap& map : pilot.maps())
  {
    folder.write(map.title() + ".traverse", map.consumer->archive());
  }
  std::string picture;
  if (pilot.costmap().size() > 0)
  {
    constexpr int kCell_px = 3;
    picture = formats::png(costPicture(
        pilot.costmap(), {result.records, &pilot.plan(), mission.goals, &settings.robot.vehicle},
        kCell_px));
    folder.write("costs.png", picture);
  }
  folder.write("report.html", reportPage(settings, pilot, result, metrics, picture));
  folder.write(std::string(formats::OutputFolder::kLastFile), textOf(metrics) + "\n");
}
}  // namespace traverse::app
