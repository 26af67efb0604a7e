// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "image_folder.h"
#include "reader_job.h"

#include <traverse/observations/to_scan.h>
#include <traverse/registration/scan_to_map.h>

#include <utility>

namespace traverse::logs
{
namespace
{
using observations::Outcome;
using registration::Verdict;

class Icp3dListener : public FrameListener
{
 public:
  Icp3dListener(FramePipe& pipe, const JobSettings& settings) :
      FrameListener(pipe),
      settings_(settings),
      image_folder_(imageFolder(settings)),
      way_(
          {settings.poses.icp_3d_voxel_m, settings.poses.icp_3d_max_range_m,
           settings.poses.limits()})
  {
  }

  void observation(const mrpt::obs::CObservation::Ptr& observation) override
  {
    const std::string type = typeOf(*observation);
    auto result = observations::toScan(*observation, settings_.sensors, image_folder_);
    if (result.outcome == Outcome::ignored)
    {
      count(Counted::ignored, type);
      return;
    }
    if (result.outcome == Outcome::rejected)
    {
      count(Counted::rejected, type, result.reason);
      return;
    }
    match(type, std::move(result.decoded.scan));
  }

  void logEnd() override
  {
    if (!waiting_.empty())
    {
      reject(waiting_, Verdict::waiting);
    }
  }

 private:
  void reject(const std::string& type, Verdict why)
  {
    count(
        Counted::rejected, type,
        std::string(registration::kVerdictNames.at(static_cast<size_t>(why))));
  }

  void match(const std::string& type, points::ScanBuffer scan)
  {
    const poses::TimeNs stamp = scan.stamp;
    countStamp(type, scan.sensor_label, stamp);
    if (stamp == 0)
    {
      count(Counted::rejected, type, "its time stamp is no clock's");
      return;
    }
    const registration::Matched matched = way_.take(std::move(scan));
    if (matched.verdict == Verdict::waiting)
    {
      waiting_ = type;
      return;
    }
    if (matched.first)
    {
      send(std::exchange(waiting_, ""), *matched.first);
    }
    if (matched.verdict != Verdict::tracked)
    {
      reject(type, matched.verdict);
      return;
    }
    send(type, {stamp, matched.T_map_base});
  }

  void send(const std::string& type, const poses::StampedPose& pose)
  {
    frames().add(pose);
    count(Counted::delivered, type);
  }

  JobSettings settings_;
  std::filesystem::path image_folder_;
  registration::ScanToMap way_;
  std::string waiting_;  // the class of the first scan until it has a pose
};
}  // namespace

std::unique_ptr<FrameListener> makeIcp3dListener(FramePipe& pipe, const JobSettings& settings)
{
  return std::make_unique<Icp3dListener>(pipe, settings);
}
}  // namespace traverse::logs
