// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_outputs.h"

#include <traverse/simulation/truth_files.h>

#include <filesystem>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
std::string withTime(const std::string& name, double at_s)
{
  const std::filesystem::path file = name;
  return fmt::format("{}_at_{}_s{}", file.stem().string(), at_s, file.extension().string());
}
}  // namespace

void writeTruth(
    formats::OutputFolder& folder,
    const SimSettings& settings,
    const simulation::Recording& recording)
{
  std::vector<double> times = settings.truth.at_s;
  if (times.empty())
  {
    times.push_back(recording.durationSeconds());
  }
  const simulation::TruthFile moving = simulation::movingThings(
      settings.scene, settings.recording.vehicle, recording.durationSeconds());
  folder.write(moving.name, moving.bytes);
  simulation::TruthRequest request;
  request.vehicle = settings.recording.vehicle;
  request.params = settings.truth.cells;
  request.start = recording.drive().at(0).translation().head<2>();
  for (size_t i = 0; i < times.size(); ++i)
  {
    request.to_s = times[i];
    for (const simulation::TruthFile& file : simulation::truthFiles(settings.scene, request))
    {
      folder.write(i + 1 < times.size() ? withTime(file.name, times[i]) : file.name, file.bytes);
    }
  }
}
}  // namespace traverse::app
