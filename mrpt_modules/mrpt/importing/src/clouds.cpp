// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "entries.h"
#include "folders.h"
#include "planned_source.h"
#include "sources.h"

#include <cmath>
#include <fmt/format.h>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;
constexpr double kFar_m = 1e4;  // from here on float32 is coarser than a millimetre

/** What the first cloud decides for all that follow. */
struct Common
{
  std::string label;
  Eigen::Isometry3d T_base_sensor = Eigen::Isometry3d::Identity();
  CloudFrame frame;
  bool own_clock = false;
};

std::vector<fs::path> cloudFiles(const fs::path& input)
{
  return fs::is_directory(input) ? filesOf(input, {".pcd", ".ply", ".bin", ".csv"})
                                 : std::vector<fs::path>{input};
}

/** Maps of surveyors are far from their zero: all clouds move by the same whole kilometres. */
void shiftFarClouds(const formats::CloudFile& cloud, CloudFrame& frame, ImportReport& report)
{
  for (size_t i = 0; i < cloud.size(); ++i)
  {
    const Eigen::Vector3d p(cloud.x[i], cloud.y[i], cloud.z[i]);
    if (!p.allFinite())
    {
      continue;
    }
    if (p.norm() > kFar_m)
    {
      const Eigen::Vector3d shift = (p / 1000).array().round() * 1000;
      frame.T_sensor_file.translation() = -shift;
      report.warnings.push_back(fmt::format(
          "the coordinates are far from zero: ({:.0f}, {:.0f}, {:.0f}) m are taken off all",
          shift.x(), shift.y(), shift.z()));
    }
    return;
  }
}

/** The first that can be read. */
std::optional<formats::CloudFile> firstCloud(const std::vector<fs::path>& files)
{
  constexpr size_t kTries = 10;
  for (size_t i = 0; i < files.size() && i < kTries; ++i)
  {
    try
    {
      return formats::readCloud(files[i]);
    }
    catch (const std::exception&)
    {
      continue;  // told when it is its turn
    }
  }
  return std::nullopt;
}

Common commonOf(
    const ImportParams& params, const std::vector<fs::path>& files, ImportReport& report)
{
  Common common;
  common.label = params.sensor_label.empty() ? "LIDAR" : params.sensor_label;
  const auto first = firstCloud(files);
  if (!first)
  {
    throw ImportError(params.input.string() + ": no cloud in it can be read");
  }
  common.T_base_sensor = params.T_base_sensor.value_or(first->viewpoint);
  if (!params.T_base_sensor && !first->viewpoint.matrix().isIdentity())
  {
    report.warnings.emplace_back(
        "the viewpoint of the first cloud is taken for the sensor's pose (--sensor-pose)");
  }
  common.frame.intensity_scale = intensityScale(*first);
  common.own_clock = first->stamp_ns.has_value();
  shiftFarClouds(*first, common.frame, report);
  if (!first->note.empty())
  {
    report.warnings.push_back(first->note);
  }
  return common;
}

poses::TimeNs timeByRate(const ImportParams& params, size_t number)
{
  return params.start + std::llround(static_cast<double>(number) / params.rateOr(10) * 1e9);
}

/** The name's time, or the cloud's own (for which it is read once more: a log is in the order of
 * time), or what the rate makes. Nothing for a cloud that cannot be read, which is reported. */
std::optional<poses::TimeNs> timeOf(
    const fs::path& file,
    size_t number,
    bool own_clock,
    const ImportParams& params,
    ImportReport& report)
{
  const auto named = stampInName(stemOf(file));
  if (named || !own_clock)
  {
    return named.value_or(timeByRate(params, number));
  }
  try
  {
    return formats::readCloud(file).stamp_ns.value_or(timeByRate(params, number));
  }
  catch (const std::exception& e)
  {
    addDamage(e.what(), report);
    return std::nullopt;
  }
}
}  // namespace

bool isClouds(const fs::path& input)
{
  std::error_code failed;
  return fs::is_directory(input, failed) ? hasFiles(input, {".pcd", ".ply", ".bin", ".csv"})
                                         : formats::isCloudName(input);
}

std::unique_ptr<Source> openClouds(const ImportParams& params)
{
  const std::vector<fs::path> files = cloudFiles(params.input);
  ImportReport report;
  const Common common = commonOf(params, files, report);
  std::vector<Step> steps;
  steps.reserve(files.size());
  bool any_named = false;
  for (size_t i = 0; i < files.size(); ++i)
  {
    any_named = any_named || stampInName(stemOf(files[i]));
    const auto stamp = timeOf(files[i], i, common.own_clock, params, report);
    if (!stamp)
    {
      continue;
    }
    const SensorAt sensor = {common.label, common.T_base_sensor, *stamp};
    steps.push_back({stamp, [file = files[i], sensor, frame = common.frame] {
                       return cloudEntry(formats::readCloud(file), sensor, frame);
                     }});
  }
  if (!any_named && !common.own_clock)
  {
    report.warnings.push_back(fmt::format(
        "the clouds have no clock: {} per second from --start-time are assumed",
        params.rateOr(10)));
  }
  return std::make_unique<PlannedSource>(std::move(steps), std::move(report), params);
}
}  // namespace traverse::importing
