// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace traverse::sandbox
{
/** A file descriptor that closes itself; -1 is none. */
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

/** A file that cannot be opened: missing, a directory, no plain file, empty, or not readable; says
 * the file and why. */
class InputError : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** A plain, readable file with something in it. */
struct InputFile
{
  Fd fd;
  uint64_t size = 0;
};

/** Throws InputError. */
InputFile openInput(const std::filesystem::path& file);
}  // namespace traverse::sandbox
