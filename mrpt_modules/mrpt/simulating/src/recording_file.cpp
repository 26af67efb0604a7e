// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/strict.h>
#include <traverse/simulating/recording_file.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

namespace traverse::simulating
{
namespace
{
using config::ConfigError;
using config::sameName;

constexpr std::string_view kLidar = "Lidar_";
constexpr std::array<std::string_view, 4> kSections = {"Vehicle", "Drive", "Ins", "Odometry"};

bool isLidar(std::string_view section)
{
  return section.size() >= kLidar.size() && sameName(section.substr(0, kLidar.size()), kLidar);
}

const config::Entry& firstEntry(const config::IniDocument& ini, std::string_view section)
{
  const auto& entries = ini.entries();
  return *std::find_if(
      entries.begin(), entries.end(),
      [&](const config::Entry& entry) { return sameName(entry.section, section); });
}

/** Number of [Lidar_NN]; they must count from 00 without a gap. */
size_t countLidars(const config::IniDocument& ini)
{
  std::vector<std::string> found;
  for (const std::string& section : ini.sections())
  {
    if (isLidar(section))
    {
      found.push_back(section);
    }
  }
  for (const std::string& section : found)
  {
    bool known = false;
    for (size_t i = 0; i < found.size(); ++i)
    {
      known = known || sameName(section, lidarSection(i));
    }
    if (!known)
    {
      throw ConfigError(
          fmt::format(
              "{}: [{}]: lidars count from [Lidar_00] without a gap, each with one key at least",
              firstEntry(ini, section).place, section),
          section);
    }
  }
  return found.size();
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

template <class P>
std::string sectionText(const std::string& name, const P& params)
{
  std::string text = fmt::format("\n[{}]\n", name);
  for (const options::Row& row : options::rows(params))
  {
    text += fmt::format("{} = {}\n", row.key, row.value);
  }
  return text;
}
}  // namespace

std::string lidarSection(size_t index)
{
  return fmt::format("{}{:02}", kLidar, index);
}

bool isOfRecording(std::string_view section)
{
  return isLidar(section) || std::any_of(
                                 kSections.begin(), kSections.end(),
                                 [&](std::string_view own) { return sameName(own, section); });
}

simulation::RecordingParams readRecording(const config::IniDocument& ini)
{
  simulation::RecordingParams params;
  const size_t lidars = countLidars(ini);
  params.lidars.resize(std::max<size_t>(lidars, 1));
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
  std::string text = sectionText("Vehicle", params.vehicle) + sectionText("Drive", params.drive);
  for (size_t i = 0; i < params.lidars.size(); ++i)
  {
    text += sectionText(lidarSection(i), params.lidars[i]);
  }
  return text + sectionText("Ins", params.ins) + sectionText("Odometry", params.odometry);
}
}  // namespace traverse::simulating
