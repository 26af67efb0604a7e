// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report_page.h"

#include <traverse/formats/report.h>
#include <traverse/nav_app/picture.h>

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

std::string shown(const Json& value, const char* unit)
{
  if (value.is_boolean())
  {
    return value.get<bool>() ? "yes" : "no";
  }
  const std::string number =
      value.is_number_float() ? fmt::format("{:.2f}", value.get<double>()) : value.dump();
  return *unit == '\0' ? number : number + " " + unit;
}

/** Those of the figures that the metrics have. */
formats::KeyFigures keyFigures(const Json& metrics)
{
  struct Figure
  {
    const char* path;
    const char* label;
    const char* unit;
  };

  constexpr Figure kFigures[] = {
      {"/reached", "reached", ""},
      {"/collisions", "collisions", ""},
      {"/conduct/drive", "share of the time that it would drive", ""},
      {"/driven_into_obstacles", "driven into what the maps call obstacles", "times"},
      {"/min_clearance_m", "nearest to anything", "m"},
      {"/time_s", "time", "s"},
      {"/way_m", "way", "m"},
      {"/stops", "stops", ""},
      {"/time_over_optimum", "time over shortest way at full speed", ""},
      {"/both_move/driven_mean_mps", "mean speed as driven", "m/s"},
      {"/both_move/commanded_mean_mps", "mean speed as commanded", "m/s"},
      {"/core_share", "share of a core that maps and control take", ""},
      {"/late_control_share", "share of control steps that took longer than a period", ""},
      {"/scans_without_pose", "scans without a pose", ""}};
  formats::KeyFigures figures;
  for (const Figure& figure : kFigures)
  {
    const Json::json_pointer at(figure.path);
    if (metrics.contains(at) && !metrics[at].is_null())
    {
      figures.figures.push_back({figure.label, shown(metrics[at], figure.unit)});
    }
  }
  return figures;
}

Section outcome(const Json& metrics, const std::string& picture)
{
  Section section{"Drive", {keyFigures(metrics)}};
  const std::string end = metrics["end"].get<std::string>();
  if (metrics.contains("reached") && !metrics["reached"].get<bool>())
  {
    section.blocks.emplace_back(formats::Notice{"The last goal was not reached: " + end});
  }
  if (metrics.contains("problem"))
  {
    const Json& problem = metrics["problem"];
    section.blocks.emplace_back(formats::Notice{
        "A replay of a recorded log: no command had an effect. It ended at " + end +
        (problem.is_null() ? "." : ": " + problem.get<std::string>())});
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

Section decisions(const Pilot& pilot, poses::TimeNs start)
{
  formats::Table table{"Stops, recoveries and their reasons", {"at", "conduct", "cause", ""}, {}};
  for (const navigation::Decision& decision : pilot.decisions())
  {
    table.rows.push_back(
        {seconds(poses::secondsBetween(start, decision.time)),
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
  report.subtitle = metrics.contains("log")
                        ? "replay of " + metrics["log"].get<std::string>()
                        : fmt::format(
                              "{}, seed {}", metrics["scene"].get<std::string>(),
                              metrics["seed"].get<uint64_t>());
  report.sections = {
      outcome(metrics, picture), motion(result), decisions(pilot, result.start), latencies(pilot)};
  report.footer = "traverse-nav " TRAVERSE_VERSION;
  return formats::html(report);
}
}  // namespace traverse::app
