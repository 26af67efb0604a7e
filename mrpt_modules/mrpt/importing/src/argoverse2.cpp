// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "csv_table.h"
#include "entries.h"
#include "folders.h"
#include "planned_source.h"
#include "sources.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;
constexpr uint16_t kLasers = 32;  // of each of the two lidars
const std::array<std::string, 2> kLidars = {"up_lidar", "down_lidar"};

/** A row of qw qx qy qz tx_m ty_m tz_m. */
Eigen::Isometry3d motionIn(const CsvTable& table, size_t row, const std::string& what)
{
  Eigen::Vector4d wxyz;
  Eigen::Vector3d t;
  const std::array<const char*, 7> names = {"qw", "qx", "qy", "qz", "tx_m", "ty_m", "tz_m"};
  for (Eigen::Index i = 0; i < 4; ++i)
  {
    wxyz[i] = table.number(row, names[static_cast<size_t>(i)]);
  }
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    t[i] = table.number(row, names[static_cast<size_t>(i + 4)]);
  }
  return rigidMotion(wxyz, t, what);
}

/** Where both lidars sit; the vehicle's origin where that is not known. */
std::array<Eigen::Isometry3d, 2> lidarPoses(const ImportParams& params, ImportReport& report)
{
  std::array<Eigen::Isometry3d, 2> T_base_lidar = {
      Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
  const auto file = plainOrGz(params.input / "egovehicle_SE3_sensor.csv");
  if (!file)
  {
    report.warnings.emplace_back("no egovehicle_SE3_sensor.csv: lidars are put at the origin");
    return T_base_lidar;
  }
  const CsvTable table(textOf(*file), file->string());
  for (size_t row = 0; row < table.rows(); ++row)
  {
    for (size_t i = 0; i < kLidars.size(); ++i)
    {
      if (table.text(row, "sensor_name") == kLidars[i])
      {
        T_base_lidar[i] = motionIn(table, row, file->string());
      }
    }
  }
  return T_base_lidar;
}

/** City coordinates are kilometres from zero, more than a map's floats bear: whole hundreds of
 * metres are taken off. */
void addPoses(const ImportParams& params, std::vector<Step>& steps, ImportReport& report)
{
  const auto file = plainOrGz(params.input / "city_SE3_egovehicle.csv");
  if (!file)
  {
    report.warnings.emplace_back("no city_SE3_egovehicle.csv: no poses");
    return;
  }
  const CsvTable table(textOf(*file), file->string());
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  for (size_t row = 0; row < table.rows(); ++row)
  {
    try
    {
      poses::StampedPose pose = {
          table.integer(row, "timestamp_ns"), motionIn(table, row, "a pose")};
      if (steps.empty())
      {
        shift = (pose.T_map_base.translation() / 100).array().round() * 100;
        report.warnings.push_back(fmt::format(
            "poses are those in the city less ({:.0f}, {:.0f}, {:.0f}) m", shift.x(), shift.y(),
            shift.z()));
      }
      pose.T_map_base.translation() -= shift;
      steps.push_back({pose.time, [pose] { return poseEntry(pose); }});
    }
    catch (const std::exception& e)
    {
      addDamage(fmt::format("{}: row {}: {}", file->string(), row + 2, e.what()), report);
    }
  }
}

/** The points of one of the lidars, seen by itself. Times are left out: the recording has already
 * moved all points to the sweep's own time. */
formats::CloudFile pointsOf(const formats::CloudFile& sweep, size_t lidar)
{
  formats::CloudFile cloud;
  for (size_t i = 0; i < sweep.size(); ++i)
  {
    if (sweep.ring.empty() || sweep.ring[i] / kLasers == lidar)
    {
      cloud.x.push_back(sweep.x[i]);
      cloud.y.push_back(sweep.y[i]);
      cloud.z.push_back(sweep.z[i]);
      if (!sweep.intensity.empty())
      {
        cloud.intensity.push_back(sweep.intensity[i]);
      }
      if (!sweep.ring.empty())
      {
        cloud.ring.push_back(sweep.ring[i] % kLasers);
      }
    }
  }
  return cloud;
}

/** Points of the vehicle frame, as the sensor's. */
Entry sweepEntry(const fs::path& file, size_t lidar, const SensorAt& sensor)
{
  CloudFrame frame;
  frame.T_sensor_file = sensor.T_base_sensor.inverse();
  frame.intensity_scale = 1.0 / 255;
  return cloudEntry(pointsOf(formats::readCloud(file), lidar), sensor, frame);
}

bool endsWith(const std::string& text, std::string_view ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/** Which lidars' points a file has: both, one, or none. */
std::array<bool, 2> lidarsIn(const fs::path& file, bool whole_sweeps)
{
  const std::string stem = stemOf(file);
  const bool full = endsWith(file.filename().string(), "_full.csv.gz") ||
                    endsWith(file.filename().string(), "_full.csv");
  if (whole_sweeps)
  {
    return {full, full};
  }
  return {endsWith(stem, "_up"), endsWith(stem, "_down")};
}

void addSweeps(const ImportParams& params, std::vector<Step>& steps, ImportReport& report)
{
  const auto T_base_lidar = lidarPoses(params, report);
  const auto files = filesOf(params.input, {".csv", ".bin"});
  const bool whole = hasFiles(params.input, {"_full.csv"});
  for (const fs::path& file : files)
  {
    const std::array<bool, 2> has = lidarsIn(file, whole);
    const auto stamp = stampInName(stemOf(file));
    for (size_t i = 0; i < kLidars.size(); ++i)
    {
      if (!has[i] || !stamp)
      {
        continue;
      }
      const SensorAt sensor = {kLidars[i], T_base_lidar[i], *stamp};
      steps.push_back({stamp, [file, i, sensor] { return sweepEntry(file, i, sensor); }});
    }
  }
  if (!whole)
  {
    report.warnings.emplace_back("no sweeps as ..._full.csv: points have no rings");
  }
}
}  // namespace

bool isArgoverse2(const fs::path& input)
{
  return plainOrGz(input / "city_SE3_egovehicle.csv").has_value() ||
         plainOrGz(input / "egovehicle_SE3_sensor.csv").has_value();
}

std::unique_ptr<Source> openArgoverse2(const ImportParams& params)
{
  ImportReport report;
  std::vector<Step> steps;
  addPoses(params, steps, report);
  addSweeps(params, steps, report);
  return std::make_unique<PlannedSource>(std::move(steps), std::move(report), params);
}
}  // namespace traverse::importing
