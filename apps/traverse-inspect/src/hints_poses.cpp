// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evidence.h"
#include "log_summary.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using diagnosis::BestFit;
constexpr double kFar_m = 3;  // a shorter way tells no direction

void hintAtTrack(const Evidence& evidence, Hints& hints)
{
  constexpr double kFastest_mps = 70;
  const poses::TrackReport& track = evidence.track.report();
  const diagnosis::Travel& travel = evidence.travel;
  hints.push_back(
      {"poses",
       "poses",
       Weight::fact,
       fmt::format(
           "{} poses from {}: {:.1f} m, at most {:.1f} m/s", track.poses, evidence.pose_source,
           travel.distance_m, travel.top_speed_mps),
       {{"distance_m", travel.distance_m}, {"top_speed_mps", travel.top_speed_mps}}});
  if (track.segments > 1 || track.gaps > 0 || track.nonfinite > 0)
  {
    hints.push_back(
        {"pose_breaks",
         "poses",
         Weight::suspicion,
         fmt::format(
             "{} jumps that no vehicle drives, {} gaps, {} that are no poses",
             std::max<size_t>(1, track.segments) - 1, track.gaps, track.nonfinite),
         {{"jumps", static_cast<double>(track.segments) - 1}}});
  }
  if (travel.top_speed_mps > kFastest_mps)
  {
    hints.push_back(
        {"pose_units",
         "poses",
         Weight::suspicion,
         "no ground vehicle is so fast: positions are not metres, or stamps not seconds",
         {{"top_speed_mps", travel.top_speed_mps}}});
  }
  constexpr double kAside_deg = 20;
  constexpr double kBack_deg = 160;
  constexpr double kMostly = 0.8;
  const double heading = std::abs(travel.heading_deg);
  if (travel.distance_m > kFar_m && travel.share > kMostly && heading > kAside_deg)
  {
    hints.push_back(
        {"forward_axis",
         "poses",
         Weight::suspicion,
         fmt::format(
             "the vehicle goes {:+.0f} deg to its x axis all along: {}", travel.heading_deg,
             heading > kBack_deg ? "it backs, or x points back"
                                 : "x does not point ahead (some lidars have y ahead, x right)"),
         {{"heading_deg", travel.heading_deg}}});
  }
}

/** The best time offsets of all sensors, those that the drive can tell. */
using Offsets = std::vector<std::pair<std::string, BestFit>>;

void hintAtOffsets(const Offsets& offsets, Hints& hints)
{
  constexpr double kSame_s = 0.03;
  const auto [least, most] = std::minmax_element(
      offsets.begin(), offsets.end(),
      [](const auto& a, const auto& b) { return a.second.value < b.second.value; });
  const bool all_alike = most->second.value - least->second.value <= kSame_s;
  const bool all_differ =
      std::all_of(offsets.begin(), offsets.end(), [](const auto& o) { return o.second.differs(); });
  if (all_alike && all_differ)
  {
    const double offset_s = (least->second.value + most->second.value) / 2;
    hints.push_back(
        {"pose_lag",
         "poses",
         Weight::suspicion,
         fmt::format(
             "scans fit best to poses stamped {:.3f} s {}: the poses {} by so much",
             std::abs(offset_s), offset_s > 0 ? "later" : "earlier",
             offset_s > 0 ? "lag" : "run ahead (or all sensors are stamped late)"),
         {{"offset_s", offset_s}}});
    return;
  }
  for (const auto& [name, fit] : offsets)
  {
    if (fit.differs())
    {
      hints.push_back(
          {"clock_offset",
           name,
           Weight::suspicion,
           fmt::format(
               "its scans fit best if {:.3f} s is {} its stamps; other sensors do not need that",
               std::abs(fit.value), fit.value > 0 ? "added to" : "taken from"),
           {{"offset_s", fit.value}}});
    }
    else
    {
      hints.push_back(
          {"clock_offset", name, Weight::fine, "its stamps fit the poses", {{"offset_s", 0}}});
    }
  }
}

void hintAtHeading(const std::string& name, const BestFit& fit, Hints& hints)
{
  constexpr double kLeast_deg = 0.5;
  if (!fit.differs() || std::abs(fit.value) < kLeast_deg)
  {
    hints.push_back(
        {"heading", name, Weight::fine, "its heading on the vehicle fits the drive", {}});
    return;
  }
  hints.push_back(
      {"heading",
       name,
       Weight::suspicion,
       fmt::format(
           "its scans fit best if they are turned by {:+.1f} deg about z: the yaw of its "
           "sensorPose "
           "does not fit, or the vehicle's x axis does not point ahead in the poses",
           fit.value),
       {{"turn_deg", fit.value}}});
}

void hintAtWhatCannotBeTold(
    const std::string& name,
    const std::optional<BestFit>& time,
    const std::optional<BestFit>& heading,
    double way_m,
    Hints& hints)
{
  if (!time || !heading)
  {
    hints.push_back({"drive", name, Weight::open, "it has less than ten scans with poses", {}});
    return;
  }
  if (!time->canTell())
  {
    hints.push_back(
        {"drive",
         name,
         Weight::open,
         "its clock cannot be told from this drive: too few bends",
         {{"contrast", time->contrast}}});
  }
  if (!heading->canTell() || way_m <= kFar_m)
  {
    hints.push_back(
        {"drive",
         name,
         Weight::open,
         "its heading cannot be told from this drive: too short a way",
         {{"contrast", heading->contrast}}});
  }
}
}  // namespace

void hintAtPoses(const Evidence& evidence, Hints& hints)
{
  if (evidence.pose_source.empty())
  {
    hints.push_back(
        {"poses",
         "log",
         Weight::open,
         "the log has no poses; clocks and headings cannot be told (give --poses FILE)",
         {}});
    return;
  }
  hintAtTrack(evidence, hints);
  const double way_m = evidence.travel.distance_m;
  Offsets offsets;
  for (const auto& [label, sensor] : evidence.sensors)
  {
    const std::string name = sensorName(label, "scan");
    const diagnosis::Crispness crispness(sensor.sighted, evidence.track);
    const auto time = crispness.timeOffset();
    const auto heading = crispness.heading();
    if (time && time->canTell())
    {
      offsets.emplace_back(name, *time);
    }
    if (heading && heading->canTell() && way_m > kFar_m)
    {
      hintAtHeading(name, *heading, hints);
    }
    hintAtWhatCannotBeTold(name, time, heading, way_m, hints);
  }
  if (!offsets.empty())
  {
    hintAtOffsets(offsets, hints);
  }
}
}  // namespace traverse::app
