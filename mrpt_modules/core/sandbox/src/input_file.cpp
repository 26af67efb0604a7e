// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sandbox/input_file.h>

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace traverse::sandbox
{
void Fd::reset()
{
  if (fd_ >= 0)
  {
    ::close(fd_);
    fd_ = -1;
  }
}

InputFile openInput(const std::filesystem::path& file)
{
  const auto fail = [&](const std::string& why)
  { throw InputError(fmt::format("{}: {}", file.string(), why)); };
  // Not blocking: a pipe without a writer would wait for ever.
  InputFile input{Fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)), 0};
  if (input.fd.get() < 0)
  {
    fail(std::generic_category().message(errno));
  }
  struct stat status = {};
  if (::fstat(input.fd.get(), &status) != 0)
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
  input.size = static_cast<uint64_t>(status.st_size);
  return input;
}
}  // namespace traverse::sandbox
