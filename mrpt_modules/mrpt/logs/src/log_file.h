// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

namespace traverse::logs
{
/** A file descriptor that closes itself. */
class Fd
{
 public:
  Fd() = default;

  explicit Fd(int fd) : fd_(fd) {}

  ~Fd() { reset(); }

  Fd(Fd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

  Fd& operator=(Fd&& other) noexcept
  {
    if (this != &other)
    {
      reset();
      fd_ = std::exchange(other.fd_, -1);
    }
    return *this;
  }

  void reset();

  int get() const { return fd_; }

 private:
  int fd_ = -1;
};

/** A plain, readable file with something in it. */
struct LogFile
{
  Fd fd;
  uint64_t size = 0;
};

/** Throws LogError. */
LogFile openLog(const std::filesystem::path& file);
}  // namespace traverse::logs
