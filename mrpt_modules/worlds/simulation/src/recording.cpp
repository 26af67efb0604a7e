// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "recording_time.h"

#include <traverse/simulation/random.h>
#include <traverse/simulation/recording.h>

#include <algorithm>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
/** Streams of random numbers; lidar i has kLidars + i. */
enum Purpose : uint64_t
{
  kIns = 1,
  kOdometry = 2,
  kLidars = 16,
};

Motion driveIn(const Scene& scene, const RecordingParams& params)
{
  if (!scene.terrain)
  {
    throw std::invalid_argument("a scene needs ground");
  }
  return driveOn(*scene.terrain, params.drive, params.vehicle);
}
}  // namespace

Recording::Recording(const Scene& scene, const RecordingParams& params, uint64_t seed) :
    caster_(scene),
    drive_(driveIn(scene, params)),
    duration_s_(drive_.poses().back().t_s),
    ins_(params.ins, mixed({seed, kIns})),
    odometry_(odometryOf(drive_, duration_s_, params.odometry, mixed({seed, kOdometry}))),
    now_(kRecordingStart)
{
  lidars_.reserve(params.lidars.size());
  streams_.reserve(params.lidars.size() + 2);
  for (size_t i = 0; i < params.lidars.size(); ++i)
  {
    lidars_.emplace_back(params.lidars[i], mixed({seed, kLidars + i}));
    streams_.push_back({0, lidars_.back().turnsUntil(duration_s_)});
  }
  streams_.push_back({0, ins_.posesUntil(duration_s_)});
  streams_.push_back({0, odometry_.size()});
  for (size_t sensor = 0; sensor < streams_.size(); ++sensor)
  {
    skipLost(sensor);
  }
}

poses::TimeNs Recording::arrivalOf(size_t sensor, uint64_t number) const
{
  if (sensor < lidars_.size())
  {
    return lidars_[sensor].arrivalOf(number);
  }
  return sensor == insNumber() ? ins_.arrivalOf(number) : odometry_[number].arrival;
}

bool Recording::isLost(size_t sensor, uint64_t number) const
{
  if (sensor < lidars_.size())
  {
    return lidars_[sensor].isLost(number);
  }
  return sensor == insNumber() && ins_.isLost(number);
}

void Recording::skipLost(size_t sensor)
{
  Stream& stream = streams_[sensor];
  while (stream.next < stream.end && isLost(sensor, stream.next))
  {
    ++stream.next;
  }
}

void Recording::advance(size_t sensor)
{
  Stream& stream = streams_[sensor];
  const int every = sensor < lidars_.size() ? lidars_[sensor].params().repeat_every : 0;
  if (every > 0 && !stream.again && (stream.next + 1) % static_cast<uint64_t>(every) == 0)
  {
    stream.again = true;
    return;
  }
  stream.again = false;
  ++stream.next;
  skipLost(sensor);
}

std::optional<Recording::Planned> Recording::plan()
{
  std::optional<Planned> first;
  for (size_t sensor = 0; sensor < streams_.size(); ++sensor)
  {
    const Stream& stream = streams_[sensor];
    if (stream.next >= stream.end)
    {
      continue;
    }
    const poses::TimeNs arrival = arrivalOf(sensor, stream.next);
    if (!first || arrival < first->arrival)
    {
      first = Planned{arrival, sensor, stream.next};
    }
  }
  if (first)
  {
    advance(first->sensor);
    now_ = first->arrival;
  }
  return first;
}

Event Recording::make(const Planned& planned) const
{
  if (planned.sensor < lidars_.size())
  {
    return lidars_[planned.sensor].turn(planned.number, caster_, drive_);
  }
  if (planned.sensor == insNumber())
  {
    return ins_.pose(planned.number, drive_);
  }
  return odometry_.at(planned.number);
}

std::optional<Event> Recording::next()
{
  const std::optional<Planned> planned = plan();
  return planned ? std::optional<Event>(make(*planned)) : std::nullopt;
}

void Recording::seek(poses::TimeNs arrival)
{
  for (size_t sensor = 0; sensor < streams_.size(); ++sensor)
  {
    streams_[sensor].next = 0;
    streams_[sensor].again = false;
    skipLost(sensor);
    while (streams_[sensor].next < streams_[sensor].end &&
           arrivalOf(sensor, streams_[sensor].next) < arrival)
    {
      advance(sensor);
    }
  }
  now_ = arrival;
}

double Recording::progress() const
{
  return std::clamp(poses::secondsBetween(kRecordingStart, now_) / duration_s_, 0.0, 1.0);
}

std::vector<poses::StampedPose> Recording::trajectory(double rate_hz) const
{
  const uint64_t count = dueUntil(duration_s_, rate_hz);
  std::vector<poses::StampedPose> poses;
  poses.reserve(count);
  for (uint64_t k = 0; k < count; ++k)
  {
    const int64_t time_ns = dueNs(k, rate_hz);
    poses.push_back({kRecordingStart + time_ns, drive_.at(secondsOf(time_ns))});
  }
  return poses;
}
}  // namespace traverse::simulation
