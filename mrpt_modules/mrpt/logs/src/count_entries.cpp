// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reader_job.h"
#include "session.h"

#include <traverse/logs/log_reader.h>

namespace traverse::logs
{
namespace
{
/** Sends entries' ends and no more. */
class CountListener : public FrameListener
{
 public:
  using FrameListener::FrameListener;

  void observation(const mrpt::obs::CObservation::Ptr& /*observation*/) override {}

  void other(const std::string& /*type*/) override {}
};
}  // namespace

LogReport countEntries(
    const std::filesystem::path& file, const LogParams& params, const ReadOptions& options)
{
  options::check(params);
  Session session(
      file, params, options,
      [](int log_fd, int frames_fd, SharedProgress& progress)
      {
        FramePipe pipe(frames_fd);
        CountListener listener(pipe);
        runJob(log_fd, pipe, progress, listener);
      });
  while (session.next())
  {
  }
  return session.report();
}
}  // namespace traverse::logs
