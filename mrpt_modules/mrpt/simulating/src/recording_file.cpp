// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ini_sections.h"

#include <traverse/config/strict.h>
#include <traverse/simulating/recording_file.h>
#include <traverse/simulation/scene_params.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

namespace traverse::simulating
{
namespace
{
using config::ConfigError;

constexpr const char* kLidar = "Lidar_";
constexpr std::array<std::string_view, 4> kSections = {"Vehicle", "Drive", "Ins", "Odometry"};

std::string lidarSection(size_t index)
{
  return simulation::numberedSection(kLidar, index);
}

void checkLabels(const simulation::RecordingParams& params)
{
  std::set<std::string> labels;
  const auto add = [&](const std::string& section, const std::string& label)
  {
    if (label.empty() || label.size() > 64 || !labels.insert(label).second)
    {
      throw ConfigError(
          fmt::format(
              "[{}] label = '{}': sensors need different names of 1 to 64 bytes", section, label),
          section, "label");
    }
  };
  for (size_t i = 0; i < params.lidars.size(); ++i)
  {
    add(lidarSection(i), params.lidars[i].label);
  }
  add("Ins", params.ins.label);
  add("Odometry", params.odometry.label);
}
}  // namespace

bool isOfRecording(std::string_view section)
{
  return beginsWith(section, kLidar) ||
         std::any_of(
             kSections.begin(), kSections.end(),
             [&](std::string_view own) { return config::sameName(own, section); });
}

simulation::RecordingParams readRecording(const config::IniDocument& ini)
{
  simulation::RecordingParams params;
  params.lidars.resize(std::max<size_t>(countNumbered(ini, kLidar), 1));
  for (size_t i = 0; i < params.lidars.size(); ++i)
  {
    params.lidars[i].label = i == 0 ? "LIDAR" : fmt::format("LIDAR_{}", i);
    config::load(ini, lidarSection(i), params.lidars[i]);
  }
  config::load(ini, "Vehicle", params.vehicle);
  config::load(ini, "Drive", params.drive);
  config::load(ini, "Ins", params.ins);
  config::load(ini, "Odometry", params.odometry);
  checkLabels(params);
  return params;
}

std::string recordingText(const simulation::RecordingParams& params)
{
  std::string text = wholeSection("Vehicle", params.vehicle) + wholeSection("Drive", params.drive);
  for (size_t i = 0; i < params.lidars.size(); ++i)
  {
    text += wholeSection(lidarSection(i), params.lidars[i]);
  }
  return text + wholeSection("Ins", params.ins) + wholeSection("Odometry", params.odometry);
}
}  // namespace traverse::simulating
