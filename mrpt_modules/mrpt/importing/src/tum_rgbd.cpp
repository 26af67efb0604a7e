// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folders.h"
#include "rgbd.h"
#include "sources.h"

#include <traverse/formats/decimal.h>
#include <traverse/formats/trajectory.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;
constexpr poses::TimeNs kSameFrame_ns = 20'000'000;  // as the benchmark's own tool has it
constexpr double kMetresPerCount = 1.0 / 5000;
constexpr Camera kUsual = {525, 525, 319.5, 239.5};

struct TimedFile
{
  poses::TimeNs stamp = 0;
  fs::path file;
};

/** A file named in a list stays within the recording's folder. */
bool isWithin(const fs::path& name)
{
  return !name.empty() && name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

/** Lines "time name", sorted by time; others are counted as skipped. */
std::vector<TimedFile> listOf(const fs::path& folder, const std::string& name, ImportReport& report)
{
  std::istringstream lines(textOf(folder / name));
  std::vector<TimedFile> list;
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::string time;
    std::string file;
    if (line.empty() || line[0] == '#' || !(words >> time))
    {
      continue;
    }
    words >> file;
    const auto stamp = formats::parseSecondsAsNs(time);
    if (!stamp || !isWithin(file))
    {
      ++report.skipped["lines of " + name + " that name no picture of this folder"];
      continue;
    }
    list.push_back({*stamp, folder / file});
  }
  std::stable_sort(
      list.begin(), list.end(),
      [](const TimedFile& a, const TimedFile& b) { return a.stamp < b.stamp; });
  return list;
}

/** The colour picture nearest in time, if it is near. */
fs::path nearest(const std::vector<TimedFile>& colours, poses::TimeNs stamp)
{
  const auto after = std::lower_bound(
      colours.begin(), colours.end(), stamp,
      [](const TimedFile& file, poses::TimeNs t) { return file.stamp < t; });
  const TimedFile* best = nullptr;
  for (const auto candidate : {after, after == colours.begin() ? after : after - 1})
  {
    if (candidate != colours.end() &&
        (best == nullptr || std::abs(candidate->stamp - stamp) < std::abs(best->stamp - stamp)))
    {
      best = &*candidate;
    }
  }
  return best != nullptr && std::abs(best->stamp - stamp) <= kSameFrame_ns ? best->file : "";
}
}  // namespace

bool isTumRgbd(const fs::path& input)
{
  std::error_code failed;
  return fs::exists(input / "depth.txt", failed) && fs::exists(input / "rgb.txt", failed);
}

std::unique_ptr<Source> openTumRgbd(const ImportParams& params)
{
  ImportReport report;
  RgbdRig rig = rgbdRig(params, kUsual);
  rig.metres_per_count = kMetresPerCount;
  if (!params.camera)
  {
    report.warnings.emplace_back("the camera is taken to be 525,525,319.5,239.5 (--camera)");
  }
  std::vector<Step> steps;
  const auto truth = params.input / "groundtruth.txt";
  if (fs::exists(truth))
  {
    for (const poses::StampedPose& pose : formats::readTrajectory(truth))
    {
      steps.push_back(cameraPoseStep(rig, pose.T_map_base, pose.time));
    }
  }
  const auto colours = listOf(params.input, "rgb.txt", report);
  for (const TimedFile& depth : listOf(params.input, "depth.txt", report))
  {
    steps.push_back(depthStep(rig, depth.file, nearest(colours, depth.stamp), depth.stamp));
  }
  return std::make_unique<PlannedSource>(std::move(steps), std::move(report), params);
}
}  // namespace traverse::importing
