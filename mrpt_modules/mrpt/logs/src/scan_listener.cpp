// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_channels.h"
#include "image_folder.h"
#include "reader_job.h"

#include <traverse/observations/convert.h>
#include <traverse/observations/to_scan.h>
#include <traverse/points/sweep.h>

#include <string_view>
#include <utility>

namespace traverse::logs
{
namespace
{
using observations::Outcome;
using observations::ScanResult;
constexpr size_t kLongestLabel = 256;
constexpr size_t kMostWaiting = 64;

template <class T>
size_t hashOf(const std::vector<T>& values)
{
  return std::hash<std::string_view>{}(
      {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

/** Tells one measurement from another of the same sensor and stamp. */
size_t hashOf(const points::Decoded& decoded)
{
  size_t hash = hashOf(decoded.image.beam);
  for (const auto* channel : {&decoded.scan.x, &decoded.scan.y, &decoded.scan.z})
  {
    hash = hash * 31 + hashOf(*channel);
  }
  return hash;
}

class ScanListener : public FrameListener
{
 public:
  ScanListener(FramePipe& pipe, const JobSettings& settings) :
      FrameListener(pipe),
      settings_(settings),
      image_folder_(imageFolder(settings)),
      channels_(settings.log)
  {
    if (!channels_.damage().empty())
    {
      count(Counted::channels_damage, "", channels_.damage());
    }
    mute(settings_.entries.first > 0);
  }

  void observation(const mrpt::obs::CObservation::Ptr& observation) override
  {
    sight(*observation);
    if (muted() && canWait(*observation))
    {
      waiting_[keyOf(*observation)] = observation;
      return;
    }
    decode(observation);
  }

  void movement(const Movement& movement) override
  {
    SightingFrame sighting;
    sighting.type = "CActionRobotMovement2D";
    sighting.stamp = movement.stamp.value_or(0);
    sight(sighting);
  }

  void entryEnd() override
  {
    FrameListener::entryEnd();
    ++entry_;
    if (muted() && entry_ >= settings_.entries.first)
    {
      for (const auto& [key, observation] : std::exchange(waiting_, {}))
      {
        decode(observation);
      }
      mute(false);
    }
  }

  bool done() const override { return entry_ >= settings_.entries.end; }

  void logEnd() override
  {
    if (done())
    {
      return;  // the rest of the log goes on with these sweeps
    }
    for (auto& [label, collector] : sweeps_)
    {
      send("CObservation2DRangeScan", collector.finish());
    }
  }

 private:
  void sight(const SightingFrame& sighting)
  {
    if (!muted())
    {
      frames().add(sighting);
    }
  }

  void sight(const mrpt::obs::CObservation& observation)
  {
    mrpt::poses::CPose3D pose;
    observation.getSensorPose(pose);
    sight(
        {labelOf(observation), typeOf(observation),
         observations::toTime(observation.timestamp).value_or(0), observations::toIsometry(pose)});
  }

  struct Last
  {
    poses::TimeNs stamp = 0;
    size_t hash = 0;
  };

  static std::string labelOf(const mrpt::obs::CObservation& observation)
  {
    return observation.sensorLabel.substr(0, kLongestLabel);
  }

  static std::string keyOf(const mrpt::obs::CObservation& observation)
  {
    return typeOf(observation) + ' ' + labelOf(observation);
  }

  /** Before the first entry that is wanted, only the latest observation of a sensor matters: a scan
   * is compared with the one before it. Rows of sweeps matter all. */
  bool canWait(const mrpt::obs::CObservation& observation) const
  {
    const bool room = waiting_.size() < kMostWaiting || waiting_.count(keyOf(observation)) > 0;
    return room && !observations::hasLabel(settings_.sensors.tilting_labels, labelOf(observation));
  }

  void decode(const mrpt::obs::CObservation::Ptr& observation)
  {
    const std::string type = typeOf(*observation);
    const std::string key = keyOf(*observation);
    const auto known = last_.find(key);
    const Last before = known == last_.end() ? Last{} : known->second;
    if (known != last_.end())
    {
      last_.erase(known);
    }
    ScanResult result = observations::toScan(*observation, settings_.sensors, image_folder_);
    if (result.outcome == Outcome::ignored)
    {
      count(Counted::ignored, type);
    }
    else if (result.outcome == Outcome::rejected)
    {
      count(Counted::rejected, type, result.reason);
    }
    else
    {
      const Last now = {result.decoded.scan.stamp, hashOf(result.decoded)};
      last_[key] = now;
      const std::string channels = channels_.attach(*observation, result.decoded.scan);
      if (!channels.empty())
      {
        count(Counted::channels, type, channels);
      }
      take(type, result.decoded, now.stamp == before.stamp && now.hash == before.hash);
    }
  }

  /** `again`: it equals its predecessor. */
  void take(const std::string& type, points::Decoded& decoded, bool again)
  {
    points::ScanBuffer& scan = decoded.scan;
    scan.sensor_label.resize(std::min(scan.sensor_label.size(), kLongestLabel));
    decoded.image.sensor_label = scan.sensor_label;
    countStamp(type, scan.sensor_label, scan.stamp);
    if (scan.stamp == 0 && !settings_.accept_bad_stamps)
    {
      count(Counted::rejected, type, "its time stamp is no clock's");
      return;
    }
    if (again && scan.stamp != 0)
    {
      count(Counted::rejected, type, "it is the scan before once more");
      return;
    }
    if (observations::hasLabel(settings_.sensors.tilting_labels, scan.sensor_label))
    {
      const std::string label = scan.sensor_label;
      send(type, sweeps_[label].add(std::move(decoded)));
      return;
    }
    send(type, std::move(decoded));
  }

  void send(const std::string& type, const std::optional<points::Decoded>& decoded)
  {
    if (decoded && !muted())
    {
      frames().add(*decoded);
      count(Counted::delivered, type);
    }
  }

  JobSettings settings_;
  std::filesystem::path image_folder_;
  CloudChannels channels_;
  std::map<std::string, Last> last_;  // by keyOf()
  std::map<std::string, points::SweepCollector> sweeps_;
  std::map<std::string, mrpt::obs::CObservation::Ptr> waiting_;  // by keyOf()
  uint64_t entry_ = 0;
};
}  // namespace

std::unique_ptr<FrameListener> makeScanListener(FramePipe& pipe, const JobSettings& settings)
{
  return std::make_unique<ScanListener>(pipe, settings);
}
}  // namespace traverse::logs
