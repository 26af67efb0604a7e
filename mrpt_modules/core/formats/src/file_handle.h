// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace traverse::formats
{
/** An open file descriptor; closed at the end of its life. */
class FileHandle
{
 public:
  FileHandle() = default;

  /** Throws FileError; `action` is for its message. */
  FileHandle(const char* action, const std::filesystem::path& path, int flags);

  FileHandle(FileHandle&& other) noexcept :
      path_(std::move(other.path_)), fd_(std::exchange(other.fd_, -1))
  {
  }

  FileHandle& operator=(FileHandle&& other) noexcept
  {
    std::swap(fd_, other.fd_);
    std::swap(path_, other.path_);
    return *this;
  }

  FileHandle(const FileHandle&) = delete;
  FileHandle& operator=(const FileHandle&) = delete;
  ~FileHandle();

  /** Everything, through short writes and interruptions. Throws FileError. */
  void write(std::string_view bytes) const;

  /** To the disk. Throws FileError. */
  void sync() const;

  /** Closing reports errors that a network file system kept until now. Throws FileError. */
  void close();

  int fd() const { return fd_; }

 private:
  std::filesystem::path path_;
  int fd_ = -1;
};

/** Makes renames and new names in a folder durable. Throws FileError. */
void syncFolder(const std::filesystem::path& folder);

/** The folder that holds a path: "." for a bare name. */
std::filesystem::path folderOf(const std::filesystem::path& path);
}  // namespace traverse::formats
