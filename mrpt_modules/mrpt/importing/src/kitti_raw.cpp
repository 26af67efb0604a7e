// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_camera.h"
#include "oxts.h"
#include "sources.h"

#include <cmath>
#include <fmt/format.h>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;
using Times = std::vector<std::optional<poses::TimeNs>>;

/** Calibration of a day, whichever of its files are there. */
struct RawCalibration
{
  NamedNumbers cameras;  //!< P_rect_0N, R_rect_00
  std::optional<Eigen::Isometry3d> T_cam0_lidar;
  std::optional<Eigen::Isometry3d> T_lidar_imu;
};

/** R and T of a file under these names. */
std::optional<Eigen::Isometry3d> motionIn(
    const NamedNumbers& named, const std::string& R, const std::string& T, const fs::path& file)
{
  const auto rotation = named.find(R);
  const auto shift = named.find(T);
  if (rotation == named.end() || shift == named.end() || rotation->second.size() != 9 ||
      shift->second.size() != 3)
  {
    return std::nullopt;
  }
  const Eigen::Matrix3d matrix =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rotation->second.data());
  return rigidMotion(matrix, Eigen::Vector3d(shift->second.data()), file.string());
}

/** Points go through R_rect_00 into the rectified frame of camera 0. */
Eigen::Isometry3d rectified(const NamedNumbers& cameras, const Eigen::Isometry3d& T_cam_lidar)
{
  NamedNumbers with_zero = cameras;
  with_zero["zero"] = {0, 0, 0};
  const auto T_rect_zero = motionIn(with_zero, "R_rect_00", "zero", "R_rect_00");
  return T_rect_zero ? *T_rect_zero * T_cam_lidar : T_cam_lidar;
}

RawCalibration readCalibration(const fs::path& drive)
{
  const fs::path named = fs::absolute(drive).lexically_normal();
  const fs::path parent = (named.has_filename() ? named : named.parent_path()).parent_path();
  RawCalibration calibration;
  for (const fs::path& folder : {drive, parent})
  {
    for (const fs::path& file : filesOf(folder, {".txt"}))
    {
      if (file.filename().string().rfind("calib_", 0) != 0)
      {
        continue;
      }
      const NamedNumbers all = namedNumbersOf(file);
      const bool imu = stemOf(file) == "calib_imu_to_velo";
      auto& alone = imu ? calibration.T_lidar_imu : calibration.T_cam0_lidar;
      const bool motion = imu || stemOf(file) == "calib_velo_to_cam";
      alone = alone || !motion ? alone : motionIn(all, "R", "T", file);
      if (!calibration.T_cam0_lidar)
      {
        calibration.T_cam0_lidar = motionIn(all, "R_velo_to_cam", "T_velo_to_cam", file);
      }
      calibration.cameras.insert(all.begin(), all.end());
    }
  }
  if (calibration.T_cam0_lidar)
  {
    calibration.T_cam0_lidar = rectified(calibration.cameras, *calibration.T_cam0_lidar);
  }
  return calibration;
}

/** Times of one sensor, by frame: of its timestamps.txt, or by rate. */
class FrameTimes
{
 public:
  FrameTimes(const fs::path& sensor, const ImportParams& params) :
      start_(params.start), rate_hz_(params.rateOr(10))
  {
    if (const auto file = plainOrGz(sensor / "timestamps.txt"))
    {
      times_ = civilTimesOf(*file);
    }
  }

  bool known() const { return !times_.empty(); }

  std::optional<poses::TimeNs> of(const fs::path& file, size_t place) const
  {
    const size_t frame = frameNumber(file).value_or(place);
    if (known())
    {
      return frame < times_.size() ? times_[frame] : std::nullopt;
    }
    return start_ + std::llround(static_cast<double>(frame) / rate_hz_ * 1e9);
  }

 private:
  Times times_;
  poses::TimeNs start_;
  double rate_hz_;
};

/** A drive: where things are, and what puts them on the vehicle. */
struct Drive
{
  const ImportParams& params;
  bool flat = false;  //!< clouds and pictures side by side in one folder
  RawCalibration calibration;
  Eigen::Isometry3d T_base_lidar = Eigen::Isometry3d::Identity();

  fs::path sensor(const std::string& name) const
  {
    return flat ? params.input : params.input / name;
  }

  fs::path data(const std::string& name) const
  {
    return flat ? params.input : params.input / name / "data";
  }
};

void addClouds(const Drive& drive, std::vector<Step>& steps, ImportReport& report)
{
  const FrameTimes times(drive.sensor("velodyne_points"), drive.params);
  if (!times.known())
  {
    report.warnings.push_back(fmt::format(
        "no timestamps of the lidar: {} frames per second from --start-time are assumed",
        drive.params.rateOr(10)));
  }
  const auto files = filesOf(drive.data("velodyne_points"), {".bin"});
  const std::string label =
      drive.params.sensor_label.empty() ? "VELODYNE" : drive.params.sensor_label;
  for (size_t i = 0; i < files.size(); ++i)
  {
    const auto stamp = times.of(files[i], i);
    if (!stamp)
    {
      addDamage(files[i].string() + ": timestamps.txt has no time for it", report);
      continue;
    }
    const SensorAt sensor = {label, drive.T_base_lidar, *stamp};
    steps.push_back({stamp, [file = files[i], sensor] {
                       return cloudEntry(formats::readCloud(file), sensor);
                     }});
  }
}

void addCameras(const Drive& drive, std::vector<Step>& steps, ImportReport& report)
{
  // A flat folder has the pictures of the left colour camera.
  for (int number = drive.flat ? 2 : 0; number < (drive.flat ? 3 : 4); ++number)
  {
    const std::string name = fmt::format("image_{:02}", number);
    if (!fs::is_directory(drive.data(name)))
    {
      continue;
    }
    const auto found = drive.calibration.cameras.find(fmt::format("P_rect_{:02}", number));
    const auto camera =
        found == drive.calibration.cameras.end() ? std::nullopt : kittiCamera(found->second);
    if (!camera || !drive.calibration.T_cam0_lidar)
    {
      report.warnings.push_back("no calibration for " + name + ": its pictures are left out");
      continue;
    }
    const FrameTimes times(drive.sensor(name), drive.params);
    addPictures(
        {drive.data(name), fmt::format("CAMERA_{}", number),
         drive.T_base_lidar * drive.calibration.T_cam0_lidar->inverse() * camera->T_cam0_camera,
         camera->pinhole},
        [&](const fs::path& file, size_t i) { return times.of(file, i); }, steps);
  }
}

void addOxts(const Drive& drive, std::vector<Step>& steps, ImportReport& report)
{
  const fs::path folder = drive.params.input / "oxts" / "data";
  if (drive.flat || !fs::is_directory(folder))
  {
    return;
  }
  if (!drive.calibration.T_lidar_imu)
  {
    report.warnings.emplace_back(
        "no calib_imu_to_velo.txt: GPS and IMU are put at the vehicle's origin");
  }
  const Eigen::Isometry3d T_base_imu = drive.calibration.T_lidar_imu
                                           ? drive.T_base_lidar * *drive.calibration.T_lidar_imu
                                           : Eigen::Isometry3d::Identity();
  if (!fs::exists(drive.params.input / "oxts" / "timestamps.txt"))
  {
    report.warnings.emplace_back(
        "oxts has no timestamps.txt: GPS and IMU count from --start-time, whatever the clouds do");
  }
  const FrameTimes times(drive.params.input / "oxts", drive.params);
  const auto files = filesOf(folder, {".txt"});
  for (size_t i = 0; i < files.size(); ++i)
  {
    const auto stamp = times.of(files[i], i);
    if (!stamp)
    {
      addDamage(files[i].string() + ": timestamps.txt has no time for it", report);
      continue;
    }
    const auto read = [file = files[i]] { return readOxts(textOf(file)); };
    steps.push_back({stamp, [=] { return gpsEntry(read(), {"GPS", T_base_imu, *stamp}); }});
    steps.push_back({stamp, [=] { return imuEntry(read(), {"IMU", T_base_imu, *stamp}); }});
  }
}

bool isFlat(const fs::path& input)
{
  for (const fs::path& file : filesOf(input, {".txt"}))
  {
    if (stemOf(file).rfind("calib_", 0) == 0)
    {
      return hasFiles(input, {".bin"});
    }
  }
  return false;
}
}  // namespace

bool isKittiRaw(const fs::path& input)
{
  std::error_code failed;
  return fs::is_directory(input / "velodyne_points" / "data", failed) ||
         (fs::is_directory(input, failed) && isFlat(input));
}

std::unique_ptr<Source> openKittiRaw(const ImportParams& params)
{
  ImportReport report;
  Drive drive{params, !fs::is_directory(params.input / "velodyne_points"), {}, {}};
  drive.T_base_lidar = kittiLidarPose(params, report);
  drive.calibration = readCalibration(params.input);
  std::vector<Step> steps;
  addOxts(drive, steps, report);
  addClouds(drive, steps, report);
  addCameras(drive, steps, report);
  return std::make_unique<PlannedSource>(std::move(steps), std::move(report), params);
}
}  // namespace traverse::importing
