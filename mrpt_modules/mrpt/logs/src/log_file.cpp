// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "log_file.h"

#include <traverse/logs/log_report.h>

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace traverse::logs
{
void Fd::reset()
{
  if (fd_ >= 0)
  {
    ::close(fd_);
    fd_ = -1;
  }
}

LogFile openLog(const std::filesystem::path& file)
{
  const auto fail = [&](const std::string& why)
  { throw LogError(fmt::format("{}: {}", file.string(), why)); };
  // Not blocking: a pipe without a writer would wait for ever.
  LogFile log{Fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)), 0};
  if (log.fd.get() < 0)
  {
    fail(std::generic_category().message(errno));
  }
  struct stat status = {};
  if (::fstat(log.fd.get(), &status) != 0)
  {
    fail(std::generic_category().message(errno));
  }
  if (S_ISDIR(status.st_mode))
  {
    fail("is a directory, not a log");
  }
  if (!S_ISREG(status.st_mode))
  {
    fail("is no plain file");
  }
  if (status.st_size == 0)
  {
    fail("is empty");
  }
  log.size = static_cast<uint64_t>(status.st_size);
  return log;
}
}  // namespace traverse::logs
