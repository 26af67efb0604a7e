// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reader_job.h"

#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/registerAllClasses.h>

namespace traverse::logs
{
namespace
{
constexpr size_t kMostLabels = 1024;

void sendDamage(FramePipe& pipe, bool first, bool compressed, const std::string& what)
{
  // A gzip file that begins well and is cut within its first object may have been a log.
  const bool foreign = first && (!compressed || what.find("gzip") == std::string::npos);
  pipe.frames().add(DamageFrame{foreign, what});
  pipe.flush();
}
}  // namespace

std::string typeOf(const mrpt::obs::CObservation& observation)
{
  return shortType(observation.GetRuntimeClass()->className);
}

void FrameListener::countStamp(
    const std::string& type, const std::string& label, poses::TimeNs stamp)
{
  if (stamp == 0)
  {
    count(Counted::bad_stamp, type);
    return;
  }
  const auto known = last_stamp_.find(label);
  if (known == last_stamp_.end())
  {
    if (last_stamp_.size() < kMostLabels)
    {
      last_stamp_[label] = stamp;
    }
    return;
  }
  if (stamp <= known->second)
  {
    count(stamp == known->second ? Counted::repeated_stamp : Counted::backward_stamp, type);
  }
  known->second = stamp;
}

void runJob(int log_fd, FramePipe& pipe, SharedProgress& progress, FrameListener& listener)
{
  mrpt::obs::registerAllClasses_mrpt_obs();
  mrpt::maps::registerAllClasses_mrpt_maps();
  ByteSource source(log_fd);
  try
  {
    LogWalk(source, progress, listener).run();
    listener.logEnd();
    pipe.frames().add(FrameType::end);
    pipe.flush();
  }
  catch (const LogDamage& e)
  {
    listener.logEnd();
    sendDamage(pipe, progress.object == 0, source.compressed(), e.what());
  }
  catch (const std::bad_alloc&)
  {
    pipe.frames().bytes().clear();
    pipe.frames().add(DamageFrame{false, "an object that needs more memory than reader_memory_mb"});
    pipe.flush();
  }
}
}  // namespace traverse::logs
