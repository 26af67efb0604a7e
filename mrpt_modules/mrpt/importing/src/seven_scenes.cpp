// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folders.h"
#include "rgbd.h"
#include "sources.h"

#include <cmath>
#include <fmt/format.h>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;
constexpr Camera kUsual = {585, 585, 320, 240};

/** "frame-000012.depth.png" -> "frame-000012". */
std::string frameName(const fs::path& depth)
{
  const std::string name = depth.filename().string();
  return name.substr(0, name.find('.'));
}

/** The number behind "frame-"; the place in the folder where there is none. */
size_t numberOf(const std::string& frame, size_t place)
{
  const size_t dash = frame.rfind('-');
  size_t number = 0;
  for (size_t i = dash == std::string::npos ? frame.size() : dash + 1; i < frame.size(); ++i)
  {
    if (frame[i] < '0' || frame[i] > '9' || number > 1'000'000'000)
    {
      return place;
    }
    number = number * 10 + static_cast<size_t>(frame[i] - '0');
  }
  return dash == std::string::npos ? place : number;
}

fs::path colourOf(const fs::path& folder, const std::string& frame)
{
  for (const char* ending : {".color.png", ".color.jpg"})
  {
    fs::path file = folder / (frame + ending);
    if (fs::exists(file))
    {
      return file;
    }
  }
  return {};
}

void addPose(
    const fs::path& file,
    const RgbdRig& rig,
    poses::TimeNs stamp,
    std::vector<Step>& steps,
    ImportReport& report)
{
  try
  {
    std::vector<double> numbers = numbersOf(textOf(file));
    if (numbers.size() == 16)
    {
      numbers.resize(12);
    }
    steps.push_back(cameraPoseStep(rig, rigidMotion(numbers, file.string()), stamp));
  }
  catch (const std::exception& e)
  {
    addDamage(file.string() + ": " + e.what(), report);
  }
}

/** Intrinsics of camera-intrinsics.txt, a matrix of 9 numbers, or the usual ones. */
Camera cameraOf(const fs::path& folder)
{
  const auto file = plainOrGz(folder / "camera-intrinsics.txt");
  const std::vector<double> K = file ? numbersOf(textOf(*file)) : std::vector<double>();
  return K.size() == 9 ? Camera{K[0], K[4], K[2], K[5]} : kUsual;
}
}  // namespace

bool isSevenScenes(const fs::path& input)
{
  return hasFiles(input, {".depth.png"});
}

std::unique_ptr<Source> openSevenScenes(const ImportParams& params)
{
  ImportReport report;
  const RgbdRig rig = rgbdRig(params, cameraOf(params.input));
  report.warnings.push_back(fmt::format(
      "the recording has no clock: frames at {} per second from --start-time are assumed",
      params.rateOr(30)));
  std::vector<Step> steps;
  const auto files = filesOf(params.input, {".depth.png"});
  for (size_t i = 0; i < files.size(); ++i)
  {
    const std::string frame = frameName(files[i]);
    const auto number = static_cast<double>(numberOf(frame, i));
    const poses::TimeNs stamp = params.start + std::llround(number / params.rateOr(30) * 1e9);
    const fs::path pose = params.input / (frame + ".pose.txt");
    if (fs::exists(pose))
    {
      addPose(pose, rig, stamp, steps, report);
    }
    steps.push_back(depthStep(rig, files[i], colourOf(params.input, frame), stamp));
  }
  if (steps.size() > files.size())
  {
    report.warnings.emplace_back(
        "poses are in the recording's own world, whose z need not point up");
  }
  return std::make_unique<PlannedSource>(std::move(steps), std::move(report), params);
}
}  // namespace traverse::importing
