// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "frame_pipe.h"
#include "log_walk.h"

#include <traverse/logs/log_params.h>
#include <traverse/observations/observation_params.h>
#include <traverse/poses/pose_source.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

// What runs in the child.
namespace traverse::logs
{
/** Sends what a walk meets to the parent. */
class FrameListener : public LogListener
{
 public:
  explicit FrameListener(FramePipe& pipe) : pipe_(pipe) {}

  void other(const std::string& type) override { count(Counted::ignored, type); }

  void entryEnd() override
  {
    if (!muted_)
    {
      pipe_.frames().add(FrameType::object);
      pipe_.flush();
    }
  }

  /** The log has come to its end, good or bad: send what was held back. */
  virtual void logEnd() {}

 protected:
  void count(Counted what, const std::string& type, const std::string& reason = "")
  {
    if (muted_)
    {
      return;
    }
    pipe_.frames().add(CountFrame{what, type, reason});
  }

  /** Counts a stamp that is none, or that does not follow its predecessor of the same sensor. */
  void countStamp(const std::string& type, const std::string& label, poses::TimeNs stamp);

  /** Tells the parent something in words. */
  void note(const std::string& what, const std::string& text)
  {
    pipe_.frames().add(CountFrame{Counted::note, what, text});
  }

  FrameWriter& frames() { return pipe_.frames(); }

  /** While muted, neither counts nor ends of entries are sent. */
  void mute(bool muted) { muted_ = muted; }

  bool muted() const { return muted_; }

 private:
  FramePipe& pipe_;
  std::map<std::string, poses::TimeNs> last_stamp_;  // by label
  bool muted_ = false;
};

/** Walks the log and tells the listener; sends how it ended. */
void runJob(int log_fd, FramePipe& pipe, SharedProgress& progress, FrameListener& listener);

/** All that decides what is sent. */
struct JobSettings
{
  std::filesystem::path log;
  observations::ObservationParams sensors;
  bool accept_bad_stamps = false;
  EntryRange entries;
  poses::PoseParams poses;
};

std::unique_ptr<FrameListener> makeScanListener(FramePipe& pipe, const JobSettings& settings);
std::unique_ptr<FrameListener> makeOdometryListener(FramePipe& pipe);
std::unique_ptr<FrameListener> makeRobotPoseListener(FramePipe& pipe);
std::unique_ptr<FrameListener> makeIcpListener(FramePipe& pipe, const JobSettings& settings);
std::unique_ptr<FrameListener> makeIcp3dListener(FramePipe& pipe, const JobSettings& settings);
std::unique_ptr<FrameListener> makeInsListener(FramePipe& pipe, const JobSettings& settings);

/** The class of an observation without its name space. */
std::string typeOf(const mrpt::obs::CObservation& observation);
}  // namespace traverse::logs
