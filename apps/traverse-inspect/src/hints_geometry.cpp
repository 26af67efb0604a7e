// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evidence.h"
#include "log_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using diagnosis::GroundSeen;
constexpr double kLean_deg = 1.0;   // less is the road, or the load
constexpr double kApart_m = 0.05;   // two sensors on one ground
constexpr double kLowest_m = 0.02;  // no sensor is nearer to the ground
constexpr double kHighest_m = 20;
constexpr double kNoGround_deg = 5;  // what leans more may be something else
constexpr double kLongWay_m = 50;    // on a shorter one the road may lean so

/** True where the ranges are nobody's metres. */
bool hintAtUnits(const std::string& name, const ScanSensor& sensor, Hints& hints)
{
  constexpr double kFar_m = 500;
  constexpr double kNear_m = 0.3;
  if (sensor.first.scan.size() == 0 || (sensor.median_m < kFar_m && sensor.farthest_m > kNear_m))
  {
    return false;
  }
  const bool large = sensor.median_m >= kFar_m;
  hints.push_back(
      {"units",
       name,
       Weight::suspicion,
       fmt::format(
           "points lie {:.4g} to {:.4g} m away: {}", sensor.nearest_m, sensor.farthest_m,
           large ? "they look like millimetres or centimetres, or the cloud is in map coordinates"
                 : "they look scaled down, for example kilometres"),
       {{"median_m", sensor.median_m}}});
  return true;
}

/** The axis of the vehicle frame that points along a direction: "+z", "-y" ...; empty for none. */
std::string axisAlong(const Eigen::Vector3d& direction)
{
  constexpr double kAlong = 0.94;  // within 20 degrees
  constexpr std::array<const char*, 3> kPlus = {"+x", "+y", "+z"};
  constexpr std::array<const char*, 3> kMinus = {"-x", "-y", "-z"};
  for (int i = 0; i < 3; ++i)
  {
    if (std::abs(direction[i]) >= kAlong)
    {
      return direction[i] > 0 ? kPlus.at(static_cast<size_t>(i))
                              : kMinus.at(static_cast<size_t>(i));
    }
  }
  return "";
}

void hintAtAxes(const std::string& name, const GroundSeen& seen, Hints& hints)
{
  const std::string axis = axisAlong(seen.up);
  std::string text;
  if (axis == "-z")
  {
    text = "it sees the ground above itself: it hangs upside down, or z points down";
  }
  else if (axis.empty())
  {
    text = fmt::format(
        "it sees a ground that leans by {:.0f} deg: its pose on the vehicle does not fit",
        std::acos(std::clamp(seen.up.z(), -1.0, 1.0)) * 57.29578);
  }
  else
  {
    text = fmt::format(
        "up is its {} axis, not +z: axes are swapped (a camera has x right, y down, z ahead; the "
        "vehicle x ahead, y left, z up)",
        axis);
  }
  hints.push_back(
      {"axes",
       name,
       Weight::suspicion,
       std::move(text),
       {{"up_x", seen.up.x()}, {"up_y", seen.up.y()}, {"up_z", seen.up.z()}}});
}

std::string leanText(const GroundSeen& seen)
{
  std::string text;
  if (std::abs(seen.pitch_deg) >= kLean_deg)
  {
    text = fmt::format(
        "the ground ahead lies {} by {:.1f} deg", seen.pitch_deg > 0 ? "lower" : "higher",
        std::abs(seen.pitch_deg));
  }
  if (std::abs(seen.roll_deg) >= kLean_deg)
  {
    text += fmt::format(
        "{}the ground at the left lies {} by {:.1f} deg", text.empty() ? "" : ", ",
        seen.roll_deg > 0 ? "lower" : "higher", std::abs(seen.roll_deg));
  }
  return text;
}

void hintAtGround(const std::string& name, const GroundSeen& seen, double way_m, Hints& hints)
{
  const std::map<std::string, double> values = {
      {"sensor_m", seen.sensor_m},
      {"base_height_m", -seen.offset_m},
      {"pitch_deg", seen.pitch_deg},
      {"roll_deg", seen.roll_deg}};
  if (seen.sensor_m < kLowest_m || seen.sensor_m > kHighest_m)
  {
    hints.push_back(
        {"units", name, Weight::suspicion,
         fmt::format(
             "it stands {:.3g} m above the ground: its units are not metres", seen.sensor_m),
         values});
    return;
  }
  const std::string lean = leanText(seen);
  if (std::max(std::abs(seen.pitch_deg), std::abs(seen.roll_deg)) > kNoGround_deg)
  {
    hints.push_back(
        {"ground", name, Weight::open,
         fmt::format(
             "a plane {:.2f} m below it, but {}: a table, a ramp, or a mount that its sensorPose "
             "does not have",
             seen.sensor_m, lean),
         values});
    return;
  }
  hints.push_back(
      {"ground", name, Weight::fact,
       fmt::format(
           "it is {:.2f} m above the ground that it sees, the vehicle's reference {:.2f} m: "
           "[Vehicle] base_height_m = {:.2f}",
           seen.sensor_m, -seen.offset_m, -seen.offset_m),
       values});
  if (lean.empty())
  {
    hints.push_back({"ground_lean", name, Weight::fine, "the ground is level under it", values});
    return;
  }
  hints.push_back(
      {"ground_lean", name, way_m < kLongWay_m ? Weight::fact : Weight::suspicion,
       fmt::format(
           "{} (by {:.1f} deg from scan to scan): a tilted mount that its sensorPose does not "
           "have, or a slope all along",
           lean, std::max(seen.pitch_spread_deg, seen.roll_spread_deg)),
       values});
}

/** Two sensors on one vehicle see one ground. */
void hintAtPair(
    const std::pair<std::string, GroundSeen>& a,
    const std::pair<std::string, GroundSeen>& b,
    Hints& hints)
{
  const double apart_m = b.second.offset_m - a.second.offset_m;
  const double pitch_deg = b.second.pitch_deg - a.second.pitch_deg;
  const double roll_deg = b.second.roll_deg - a.second.roll_deg;
  if (std::abs(apart_m) < kApart_m && std::abs(pitch_deg) < kLean_deg &&
      std::abs(roll_deg) < kLean_deg)
  {
    return;
  }
  hints.push_back(
      {"sensor_pose",
       b.first,
       Weight::suspicion,
       fmt::format(
           "it does not see the ground where {} sees it: {:.2f} m {}, pitch {:+.1f} deg, roll "
           "{:+.1f} deg; one of their sensorPoses does not fit",
           a.first, std::abs(apart_m), apart_m > 0 ? "higher" : "lower", pitch_deg, roll_deg),
       {{"apart_m", apart_m}, {"pitch_deg", pitch_deg}, {"roll_deg", roll_deg}}});
}
}  // namespace

void hintAtGeometry(const Evidence& evidence, Hints& hints)
{
  const double way_m = evidence.travel.distance_m;
  std::vector<std::pair<std::string, GroundSeen>> level;
  for (const auto& [label, sensor] : evidence.sensors)
  {
    const std::string name = sensorName(label, "scan");
    const auto known = evidence.census.find(label);
    if (known == evidence.census.end() || hintAtUnits(name, known->second, hints) ||
        sensor.looked_at == 0)
    {
      continue;
    }
    if (const auto seen = groundOf(sensor))
    {
      hintAtGround(name, *seen, way_m, hints);
      level.emplace_back(name, *seen);
    }
    else if (sensor.tilted.size() * 2 > sensor.looked_at)
    {
      hintAtAxes(name, *diagnosis::agree(sensor.tilted), hints);
    }
    else
    {
      hints.push_back(
          {"ground", name, Weight::open, "no ground was found in most of its scans", {}});
    }
  }
  for (size_t i = 1; i < level.size(); ++i)
  {
    hintAtPair(level[0], level[i], hints);
  }
}
}  // namespace traverse::app
