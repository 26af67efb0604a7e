// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "log_summary.h"

#include <traverse/observations/convert.h>
#include <traverse/options/untrusted_text.h>
#include <traverse/poses/timing.h>

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <numbers>

namespace traverse::app
{
namespace
{
constexpr double kDegree = std::numbers::pi / 180;

std::string ending(logs::LogEnd end)
{
  switch (end)
  {
    case logs::LogEnd::complete:
      return "complete";
    case logs::LogEnd::damaged:
      return "damaged";
    case logs::LogEnd::not_a_log:
      return "not a log";
    case logs::LogEnd::stopped:
    case logs::LogEnd::reading:
      break;
  }
  return "stopped";
}

std::string poseText(const logs::SensorTimes& sensor)
{
  if (!sensor.T_base_sensor.matrix().allFinite())
  {
    return "no finite sensor pose";
  }
  const mrpt::poses::CPose3D pose = observations::toPose3D(sensor.T_base_sensor);
  return fmt::format(
      "at {:.3f} {:.3f} {:.3f} m, yaw {:.2f} pitch {:.2f} roll {:.2f} deg{}", pose.x(), pose.y(),
      pose.z(), pose.yaw() / kDegree, pose.pitch() / kDegree, pose.roll() / kDegree,
      sensor.sensor_pose_changes ? ", and moves" : "");
}

std::string timingText(const logs::SensorTimes& sensor)
{
  const poses::Timing timing = poses::timingOf(sensor.stamps);
  std::string text;
  if (timing.median_period_s > 0)
  {
    text = fmt::format(
        "{:.2f} Hz, periods {:.4f} to {:.4f} s", timing.rateHz(), timing.shortest_period_s,
        timing.longest_period_s);
  }
  if (!timing.gaps.empty())
  {
    text += fmt::format(", {} gaps", timing.gaps.size());
  }
  for (const auto& [name, count] :
       {std::pair("repeated", sensor.repeated), std::pair("backward", sensor.backward),
        std::pair("bad stamps", sensor.bad)})
  {
    text += count > 0 ? fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name) : "";
  }
  return text.empty() ? "one time only" : text;
}

std::string counts(const std::string& title, const std::map<std::string, uint64_t>& counts)
{
  std::string text;
  for (const auto& [name, count] : counts)
  {
    text += fmt::format("  {} {}\n", count, shown(name));
  }
  return text.empty() ? "" : title + "\n" + text;
}

std::string scanText(const std::string& label, const ScanSensor& sensor)
{
  const points::ScanBuffer& scan = sensor.first.scan;
  std::string text = fmt::format(
      "  {}: {} scans, {:.0f} points each", sensorName(label, "scan"), sensor.scans,
      static_cast<double>(sensor.points) / static_cast<double>(sensor.scans));
  if (scan.size() > 0)
  {
    text += fmt::format(
        ", {:.2f} to {:.2f} m (half within {:.2f})", sensor.nearest_m, sensor.farthest_m,
        sensor.median_m);
    text += scan.ring.empty() ? "" : ", rings";
    text += scan.time_s.empty() ? "" : ", a time per point";
    text += scan.intensity.empty() ? "" : ", intensity";
    text += scan.rgb.empty() ? "" : ", colour";
  }
  for (size_t i = 0; i < points::kRejectCount; ++i)
  {
    if (sensor.rejects.count[i] > 0)
    {
      text += fmt::format(", {} {}", sensor.rejects.count[i], points::kRejectNames[i]);
    }
  }
  return text + "\n";
}

std::pair<poses::TimeNs, poses::TimeNs> spanOf(const logs::LogReport& report)
{
  std::pair<poses::TimeNs, poses::TimeNs> span{0, 0};
  for (const logs::SensorTimes& sensor : report.sensors)
  {
    if (sensor.first != 0)
    {
      span.first = span.first == 0 ? sensor.first : std::min(span.first, sensor.first);
      span.second = std::max(span.second, sensor.last);
    }
  }
  return span;
}
}  // namespace

std::string dateOf(poses::TimeNs time)
{
  constexpr poses::TimeNs kSecond = 1'000'000'000;
  const std::time_t seconds = time / kSecond;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &utc);
  return fmt::format("{}.{:03} UTC", text.data(), time % kSecond / 1'000'000);
}

std::string shown(const std::string& untrusted)
{
  constexpr size_t kLongest = 60;
  return options::printable(untrusted, kLongest);
}

std::string sensorName(const std::string& label, const std::string& type)
{
  return label.empty() ? "(" + shown(type) + " without a label)" : shown(label);
}

std::string summaryText(
    const std::string& name, const logs::LogReport& report, const ScanCensus& census)
{
  const auto [first, last] = spanOf(report);
  std::string text = fmt::format(
      "{}: {} bytes, {} entries, {}\n", name, report.file_size, report.objects, ending(report.end));
  if (first != 0)
  {
    text += fmt::format(
        "{} to {}, {:.1f} s\n", dateOf(first), dateOf(last), poses::secondsBetween(first, last));
  }
  text += "sensors\n";
  for (const logs::SensorTimes& sensor : report.sensors)
  {
    text += fmt::format(
        "  {} {}: {}, {}; {}\n", sensorName(sensor.label, sensor.type), sensor.type, sensor.count,
        timingText(sensor), poseText(sensor));
  }
  text += census.empty() ? "" : "scans\n";
  for (const auto& [label, sensor] : census)
  {
    text += scanText(label, sensor);
  }
  text += counts("left aside", report.ignored);
  text += counts("rejected", report.rejected);
  return text;
}

Json summaryJson(const std::string& name, const logs::LogReport& report, const ScanCensus& census)
{
  Json json{
      {"log", name},
      {"bytes", report.file_size},
      {"entries", report.objects},
      {"end", ending(report.end)},
      {"damage", report.damage}};
  json["sensors"] = Json::array();
  for (const logs::SensorTimes& sensor : report.sensors)
  {
    const poses::Timing timing = poses::timingOf(sensor.stamps);
    json["sensors"].push_back(
        {{"label", sensor.label},
         {"class", sensor.type},
         {"count", sensor.count},
         {"first_ns", sensor.first},
         {"last_ns", sensor.last},
         {"rate_hz", timing.rateHz()},
         {"longest_period_s", timing.longest_period_s},
         {"gaps", timing.gaps.size()},
         {"repeated", sensor.repeated},
         {"backward", sensor.backward},
         {"bad_stamps", sensor.bad},
         {"pose", poseText(sensor)}});
  }
  json["scans"] = Json::array();
  for (const auto& [label, sensor] : census)
  {
    json["scans"].push_back(
        {{"label", label},
         {"scans", sensor.scans},
         {"points", sensor.points},
         {"nearest_m", sensor.nearest_m},
         {"median_m", sensor.median_m},
         {"farthest_m", sensor.farthest_m},
         {"rings", !sensor.first.scan.ring.empty()},
         {"point_times", !sensor.first.scan.time_s.empty()}});
  }
  json["ignored"] = report.ignored;
  json["rejected"] = report.rejected;
  return json;
}
}  // namespace traverse::app
