// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reader_job.h"
#include "session.h"

#include <traverse/logs/log_reader.h>

namespace traverse::logs
{
class LogReader::Impl
{
 public:
  Impl(
      const std::filesystem::path& file,
      const LogParams& params,
      const ReadOptions& options,
      const JobSettings& settings) :
      session_(
          file,
          params,
          options,
          [settings](int log_fd, int frames_fd, SharedProgress& progress)
          {
            FramePipe pipe(frames_fd);
            const auto listener = makeScanListener(pipe, settings);
            runJob(log_fd, pipe, progress, *listener);
          })
  {
  }

  Session& session() { return session_; }

 private:
  Session session_;
};

LogReader::LogReader(
    const std::filesystem::path& file,
    const LogParams& params,
    const observations::ObservationParams& sensors,
    const ReadOptions& options)
{
  options::check(params);
  options::check(sensors);
  observations::checkTogether(sensors);
  impl_ = std::make_unique<Impl>(
      file, params, options,
      JobSettings{file, sensors, options.accept_bad_stamps, options.entries});
}

LogReader::~LogReader() = default;
LogReader::LogReader(LogReader&&) noexcept = default;
LogReader& LogReader::operator=(LogReader&&) noexcept = default;

std::optional<points::Decoded> LogReader::next()
{
  auto product = impl_->session().next();
  if (product && std::holds_alternative<points::Decoded>(*product))
  {
    return std::get<points::Decoded>(std::move(*product));
  }
  return std::nullopt;
}

const LogReport& LogReader::report() const
{
  return impl_->session().report();
}
}  // namespace traverse::logs
