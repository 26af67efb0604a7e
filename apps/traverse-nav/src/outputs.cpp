// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "report_page.h"

#include <traverse/formats/trajectory.h>
#include <traverse/nav_app/picture.h>
#include <traverse/poses/level_pose.h>

#include <fmt/format.h>

namespace traverse::app
{
namespace
{
std::string trajectory(const DriveResult& result)
{
  std::vector<poses::StampedPose> poses;
  for (const DriveRecord& record : result.records)
  {
    poses.push_back(
        {poses::later(result.start, record.t_s), poses::levelPose(record.vehicle.pose)});
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

std::string decisionTable(const Pilot& pilot, poses::TimeNs start)
{
  std::string text = "t_s,conduct,cause,text\n";
  for (const navigation::Decision& decision : pilot.decisions())
  {
    text += fmt::format(
        "{:.3f},{},{},\"{}\"\n", poses::secondsBetween(start, decision.time),
        nameOf(decision.conduct), nameOf(decision.cause), decision.text);
  }
  return text;
}
}  // namespace

void writeDrive(
    formats::OutputFolder& folder,
    const NavSettings& settings,
    const Pilot& pilot,
    const std::vector<navigation::Goal>& goals,
    const DriveResult& result,
    const Json& metrics)
{
  folder.write("trajectory.tum", trajectory(result));
  folder.write("drive.csv", table(result));
  folder.write("decisions.csv", decisionTable(pilot, result.start));
  for (const BuiltMap& map : pilot.maps())
  {
    folder.write(map.title() + ".traverse", map.consumer->archive());
  }
  std::string picture;
  if (pilot.costmap().size() > 0)
  {
    constexpr int kCell_px = 3;
    picture = formats::png(costPicture(
        pilot.costmap(), {result.records, &pilot.plan(), goals, &settings.robot.vehicle},
        kCell_px));
    folder.write("costs.png", picture);
  }
  folder.write("report.html", reportPage(settings, pilot, result, metrics, picture));
  folder.write(std::string(formats::OutputFolder::kLastFile), textOf(metrics) + "\n");
}
}  // namespace traverse::app
