// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_camera.h"
#include "sources.h"

#include <traverse/formats/bytes.h>

#include <cmath>
#include <fmt/format.h>

namespace traverse::importing
{
namespace
{
namespace fs = std::filesystem;

/** What is known of a sequence beside its files. */
struct Sequence
{
  fs::path folder;
  std::string label;
  Eigen::Isometry3d T_base_lidar = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_cam0_lidar;
  NamedNumbers calibration;
  std::vector<poses::TimeNs> times;  //!< by frame; empty: by rate
  poses::TimeNs start = 0;
  double rate_hz = 10;

  std::optional<poses::TimeNs> timeOf(size_t frame) const
  {
    if (!times.empty())
    {
      return frame < times.size() ? std::optional(times[frame]) : std::nullopt;
    }
    return start + std::llround(static_cast<double>(frame) / rate_hz * 1e9);
  }
};

void readTimes(const ImportParams& params, Sequence& sequence, ImportReport& report)
{
  report.warnings.emplace_back("the recording has no clock: its times count from --start-time");
  const auto file = plainOrGz(params.input / "times.txt");
  if (!file)
  {
    report.warnings.push_back(
        fmt::format("no times.txt: {} frames per second are assumed", params.rateOr(10)));
    return;
  }
  for (const double t_s : numbersOf(textOf(*file)))
  {
    if (std::abs(t_s) > 1e8)
    {
      throw ImportError(file->string() + ": has a time that is none");
    }
    sequence.times.push_back(params.start + std::llround(t_s * 1e9));
  }
}

void readCalibration(const ImportParams& params, Sequence& sequence, ImportReport& report)
{
  if (const auto file = plainOrGz(params.input / "calib.txt"))
  {
    sequence.calibration = namedNumbersOf(*file);
    for (const char* name : {"Tr", "Tr_velo_to_cam", "Tr_velo_cam"})
    {
      const auto found = sequence.calibration.find(name);
      if (found != sequence.calibration.end() && !sequence.T_cam0_lidar)
      {
        sequence.T_cam0_lidar = rigidMotion(found->second, file->string());
      }
    }
  }
  else if (const auto alone = plainOrGz(params.input / "Tr_velo_to_cam0.txt"))
  {
    sequence.T_cam0_lidar = rigidMotion(numbersOf(textOf(*alone)), alone->string());
  }
  if (!sequence.T_cam0_lidar)
  {
    report.warnings.emplace_back("no calibration of lidar and camera (Tr): no pictures");
  }
}

struct PoseFile
{
  fs::path file;
  bool of_camera = true;
};

std::optional<PoseFile> findPoses(const fs::path& input)
{
  const fs::path folder = fs::absolute(input).lexically_normal();
  const fs::path named = folder.has_filename() ? folder : folder.parent_path();
  const std::string name = named.filename().string() + ".txt";
  for (const PoseFile& candidate :
       {PoseFile{named / "poses_velodyne_world.txt", false}, PoseFile{named / "poses.txt"},
        PoseFile{named.parent_path().parent_path() / "poses" / name},
        PoseFile{named.parent_path() / "poses" / name}})
  {
    if (const auto file = plainOrGz(candidate.file))
    {
      return PoseFile{*file, candidate.of_camera};
    }
  }
  return std::nullopt;
}

/** Rows of 12 numbers, or of 13 with the frame's number before. */
std::vector<std::vector<double>> rowsOf(const fs::path& file)
{
  const std::string text = textOf(file);
  const size_t columns = numbersOf(std::string_view(text).substr(0, text.find('\n'))).size();
  const std::vector<double> all = numbersOf(text);
  if ((columns != 12 && columns != 13) || all.size() % columns != 0)
  {
    throw formats::FormatError(file.string() + ": has not 12 or 13 numbers in each row");
  }
  std::vector<std::vector<double>> rows;
  rows.reserve(all.size() / columns);
  for (size_t i = 0; i < all.size(); i += columns)
  {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i);
    std::vector<double> row(begin, begin + static_cast<std::ptrdiff_t>(columns));
    if (columns == 12)
    {
      const size_t frame = i / columns;
      row.insert(row.begin(), static_cast<double>(frame));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/** Poses of camera or lidar as those of the vehicle, in the map of its first frame. */
void addPoses(const Sequence& sequence, std::vector<Step>& steps, ImportReport& report)
{
  const auto poses = findPoses(sequence.folder);
  if (!poses || (poses->of_camera && !sequence.T_cam0_lidar))
  {
    report.warnings.emplace_back("no poses");
    return;
  }
  const Eigen::Isometry3d T_posed_lidar =
      poses->of_camera ? *sequence.T_cam0_lidar : Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d T_posed_base = T_posed_lidar * sequence.T_base_lidar.inverse();
  for (const std::vector<double>& row : rowsOf(poses->file))
  {
    const double frame = row[0];
    const auto stamp =
        frame >= 0 && frame < 1e9 ? sequence.timeOf(static_cast<size_t>(frame)) : std::nullopt;
    if (!stamp)
    {
      addDamage(poses->file.string() + ": a pose of a frame without a time", report);
      continue;
    }
    const Eigen::Isometry3d T_world_posed =
        rigidMotion(std::vector<double>(row.begin() + 1, row.end()), poses->file.string());
    const poses::StampedPose pose = {*stamp, T_posed_base.inverse() * T_world_posed * T_posed_base};
    steps.push_back({stamp, [pose] { return poseEntry(pose); }});
  }
}

void addClouds(const Sequence& sequence, std::vector<Step>& steps, ImportReport& report)
{
  const auto files = filesOf(sequence.folder / "velodyne", {".bin"});
  for (size_t i = 0; i < files.size(); ++i)
  {
    const auto stamp = sequence.timeOf(frameNumber(files[i]).value_or(i));
    if (!stamp)
    {
      addDamage(files[i].string() + ": times.txt has no time for it", report);
      continue;
    }
    const SensorAt sensor = {sequence.label, sequence.T_base_lidar, *stamp};
    steps.push_back({stamp, [file = files[i], sensor] {
                       return cloudEntry(formats::readCloud(file), sensor);
                     }});
  }
}

void addCameras(const Sequence& sequence, std::vector<Step>& steps)
{
  for (int number = 0; number < 4 && sequence.T_cam0_lidar; ++number)
  {
    const auto projection = sequence.calibration.find(fmt::format("P{}", number));
    const auto camera =
        projection == sequence.calibration.end() ? std::nullopt : kittiCamera(projection->second);
    const fs::path folder = sequence.folder / fmt::format("image_{}", number);
    if (!camera || !fs::is_directory(folder))
    {
      continue;
    }
    const Eigen::Isometry3d T_base_camera =
        sequence.T_base_lidar * sequence.T_cam0_lidar->inverse() * camera->T_cam0_camera;
    addPictures(
        {folder, fmt::format("CAMERA_{}", number), T_base_camera, camera->pinhole},
        [&](const fs::path& file, size_t i)
        { return sequence.timeOf(frameNumber(file).value_or(i)); },
        steps);
  }
}
}  // namespace

bool isKittiOdometry(const fs::path& input)
{
  return hasFiles(input / "velodyne", {".bin"});
}

std::unique_ptr<Source> openKittiOdometry(const ImportParams& params)
{
  ImportReport report;
  Sequence sequence;
  sequence.folder = params.input;
  sequence.label = params.sensor_label.empty() ? "VELODYNE" : params.sensor_label;
  sequence.start = params.start;
  sequence.rate_hz = params.rateOr(10);
  sequence.T_base_lidar = kittiLidarPose(params, report);
  readTimes(params, sequence, report);
  readCalibration(params, sequence, report);
  std::vector<Step> steps;
  addPoses(sequence, steps, report);  // first: a log reader has the pose before its cloud
  addClouds(sequence, steps, report);
  addCameras(sequence, steps);
  return std::make_unique<PlannedSource>(std::move(steps), std::move(report), params);
}
}  // namespace traverse::importing
