// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_page.h"

#include <traverse/formats/report.h>
#include <traverse/nav_app/picture.h>
#include <traverse/simulation/lidar.h>

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace traverse::app
{
namespace
{
using formats::Section;

std::string seconds(double s)
{
  return fmt::format("{:.1f} s", s);
}

Section outcome(const DriveResult& result, const Json& metrics, const std::string& picture)
{
  formats::KeyFigures figures;
  figures.figures = {
      {"reached", result.reached ? "yes" : "no"},
      {"collisions", std::to_string(result.collisions)},
      {"nearest to anything", fmt::format("{:.2f} m", result.min_clearance_m)},
      {"time", seconds(result.time_s)},
      {"way", fmt::format("{:.1f} m", result.way_m)},
      {"stops", std::to_string(result.stops)}};
  if (metrics["time_over_optimum"].is_number())
  {
    figures.figures.push_back(
        {"time over shortest way at full speed",
         fmt::format("{:.2f}", metrics["time_over_optimum"].get<double>())});
  }
  Section section{"Drive", {figures}};
  if (!result.reached)
  {
    section.blocks.emplace_back(formats::Notice{"The last goal was not reached: " + result.end});
  }
  if (!picture.empty())
  {
    section.blocks.emplace_back(
        formats::Picture{picture, "The costs as they were at the end, and the driven way", true});
    section.blocks.emplace_back(formats::Legend{costLegend()});
  }
  return section;
}

Section motion(const DriveResult& result)
{
  std::vector<float> speeds, clearances;
  std::map<std::string, double> held;
  for (const DriveRecord& record : result.records)
  {
    speeds.push_back(static_cast<float>(record.vehicle.twist.speed_mps));
    clearances.push_back(static_cast<float>(record.clearance_m));
    held[std::string(nameOf(record.pilot.limited_by))] += 1;
  }
  formats::BarChart reasons{"What held the speed down", "% of the time", {}};
  for (const auto& [reason, count] : held)
  {
    const auto all = static_cast<double>(result.records.size());
    reasons.bars.push_back({reason, std::round(1000 * count / all) / 10, std::nullopt});
  }
  return {
      "Speeds and clearances",
      {formats::histogramOf(speeds, 24, "Speed", "m/s"),
       formats::histogramOf(clearances, 24, "Clearance of the outline", "m"), reasons}};
}

Section decisions(const Pilot& pilot)
{
  formats::Table table{"Stops, recoveries and their reasons", {"at", "conduct", "cause", ""}, {}};
  for (const navigation::Decision& decision : pilot.decisions())
  {
    table.rows.push_back(
        {seconds(poses::secondsBetween(simulation::kRecordingStart, decision.time)),
         std::string(nameOf(decision.conduct)), std::string(nameOf(decision.cause)),
         decision.text});
  }
  return {"Decisions", {table}};
}

Section latencies(const Pilot& pilot)
{
  formats::Table table{
      "Time of each stage, ms", {"stage", "times", "50 %", "95 %", "99 %", "most"}, {}};
  for (size_t i = 0; i < kStageNames.size(); ++i)
  {
    const auto stage = static_cast<Stage>(i);
    const Latencies& all = pilot.latencies();
    std::vector<std::string> row = {std::string(kStageNames[i]), std::to_string(all.count(stage))};
    for (const double share : {0.5, 0.95, 0.99, 1.0})
    {
      row.push_back(fmt::format("{:.2f}", all.percentileMs(stage, share)));
    }
    table.rows.push_back(row);
  }
  return {"Latency", {table}};
}
}  // namespace

std::string reportPage(
    const NavSettings& settings,
    const Pilot& pilot,
    const DriveResult& result,
    const Json& metrics,
    const std::string& picture)
{
  formats::Report report;
  report.title = settings.run.title;
  report.subtitle = fmt::format(
      "{}, seed {}", settings.scene.filename().string(), metrics["seed"].get<uint64_t>());
  report.sections = {
      outcome(result, metrics, picture), motion(result), decisions(pilot), latencies(pilot)};
  report.footer = "traverse-nav " TRAVERSE_VERSION;
  return formats::html(report);
}
}  // namespace traverse::app
