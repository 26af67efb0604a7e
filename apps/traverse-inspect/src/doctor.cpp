// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "doctor.h"

#include "evidence.h"
#include "read_scans.h"

#include <traverse/common_app/input_file.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/formats/trajectory.h>
#include <traverse/logs/log_poses.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using poses::PoseSource;

bool has(const logs::LogReport& report, std::string_view type)
{
  return std::any_of(
      report.sensors.begin(), report.sensors.end(),
      [&](const logs::SensorTimes& sensor) { return sensor.type == type; });
}

/** The name of a pose source, or empty: what the log has. */
std::string sourceIn(const logs::LogReport& report)
{
  if (has(report, "CObservationRobotPose"))
  {
    return "robot_pose";
  }
  if (has(report, "CObservationOdometry") || has(report, "CActionRobotMovement2D"))
  {
    return "odometry";
  }
  return has(report, "CObservationGPS") ? "ins" : "";
}

std::vector<poses::StampedPose> posesFrom(const InspectCommand& command, const std::string& source)
{
  for (const auto& [known, name] : options::EnumNames<PoseSource>::kNames)
  {
    if (source == name && known != PoseSource::file && known != PoseSource::identity)
    {
      logs::ReadOptions options;
      options.stop = &Interrupt::flag();
      return logs::readLogPoses(command.input, known, {}, {}, options).poses;
    }
  }
  return asInput([&] { return formats::readTrajectory(source, command.times); });
}

const char* nameOf(Weight weight)
{
  constexpr std::array<const char*, 4> kNames = {"fine", "cannot tell", "fact", "suspicion"};
  return kNames.at(static_cast<size_t>(weight));
}
}  // namespace

Diagnosis examine(const InspectCommand& command)
{
  Evidence evidence;
  evidence.report = readScans(
      command.input, command.quiet,
      [&](points::Decoded decoded) { addTo(evidence, std::move(decoded)); });
  evidence.pose_source = command.poses.empty() ? sourceIn(evidence.report) : command.poses;
  if (!evidence.pose_source.empty())
  {
    evidence.track = poses::PoseTrack(posesFrom(command, evidence.pose_source));
    evidence.travel = diagnosis::travelOf(evidence.track);
  }
  Diagnosis diagnosis;
  hintAtTimes(evidence, diagnosis.hints);
  hintAtGeometry(evidence, diagnosis.hints);
  hintAtPoses(evidence, diagnosis.hints);
  diagnosis.report = std::move(evidence.report);
  return diagnosis;
}

std::string hintsText(const Hints& hints)
{
  std::string text;
  for (const Weight weight : {Weight::suspicion, Weight::fact, Weight::open, Weight::fine})
  {
    for (const Hint& hint : hints)
    {
      if (hint.weight == weight)
      {
        text += fmt::format("{:<11} {}: {}\n", nameOf(weight), hint.about, hint.text);
      }
    }
  }
  return text;
}

Json hintsJson(const Hints& hints)
{
  Json json = Json::array();
  for (const Hint& hint : hints)
  {
    json.push_back(
        {{"key", hint.key},
         {"about", hint.about},
         {"weight", nameOf(hint.weight)},
         {"text", hint.text},
         {"values", hint.values}});
  }
  return json;
}
}  // namespace traverse::app
