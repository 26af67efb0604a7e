// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reader_job.h"
#include "session.h"

#include <traverse/logs/log_poses.h>

#include <stdexcept>

namespace traverse::logs
{
namespace
{
using poses::PoseSource;

std::unique_ptr<FrameListener> makeListener(
    PoseSource source, FramePipe& pipe, const JobSettings& settings)
{
  switch (source)
  {
    case PoseSource::odometry:
      return makeOdometryListener(pipe);
    case PoseSource::robot_pose:
      return makeRobotPoseListener(pipe);
    case PoseSource::icp_2d:
      return makeIcpListener(pipe, settings);
    case PoseSource::icp_3d:
      return makeIcp3dListener(pipe, settings);
    case PoseSource::ins:
      return makeInsListener(pipe, settings);
    case PoseSource::identity:
    case PoseSource::file:
      break;
  }
  throw std::invalid_argument("readLogPoses: this pose source does not come from the log");
}
}  // namespace

PoseReading readLogPoses(
    const std::filesystem::path& file,
    const poses::PoseParams& wanted,
    const LogParams& params,
    const observations::ObservationParams& sensors,
    const ReadOptions& options)
{
  const PoseSource source = wanted.source;
  if (source == PoseSource::identity || source == PoseSource::file)
  {
    throw std::invalid_argument("readLogPoses: this pose source does not come from the log");
  }
  options::check(params);
  options::check(wanted);
  const JobSettings settings{file, sensors, options.accept_bad_stamps, {}, wanted};
  Session session(
      file, params, options,
      [&](int log_fd, int frames_fd, SharedProgress& progress)
      {
        FramePipe pipe(frames_fd);
        const auto listener = makeListener(source, pipe, settings);
        runJob(log_fd, pipe, progress, *listener);
      });
  PoseReading reading;
  while (const auto product = session.next())
  {
    if (const auto* pose = std::get_if<poses::StampedPose>(&*product))
    {
      reading.poses.push_back(*pose);
    }
  }
  reading.report = session.report();
  return reading;
}

PoseReading readLogPoses(
    const std::filesystem::path& file,
    PoseSource source,
    const LogParams& params,
    const observations::ObservationParams& sensors,
    const ReadOptions& options)
{
  poses::PoseParams wanted;
  wanted.source = source;
  return readLogPoses(file, wanted, params, sensors, options);
}
}  // namespace traverse::logs
