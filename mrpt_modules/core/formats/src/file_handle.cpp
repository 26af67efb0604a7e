// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file_handle.h"

#include <traverse/formats/safe_file.h>

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace traverse::formats
{
namespace
{
constexpr mode_t kMode = 0666;  // less what the umask takes

int openRetrying(const std::filesystem::path& path, int flags)
{
  int fd = -1;
  do
  {
    fd = ::open(path.c_str(), flags | O_CLOEXEC, kMode);
  } while (fd < 0 && errno == EINTR);
  return fd;
}
}  // namespace

FileHandle::FileHandle(const char* action, const std::filesystem::path& path, int flags) :
    path_(path), fd_(openRetrying(path, flags))
{
  if (fd_ < 0)
  {
    throw FileError(action, path, errno);
  }
}

FileHandle::~FileHandle()
{
  if (fd_ >= 0)
  {
    ::close(fd_);
  }
}

void FileHandle::write(std::string_view bytes) const
{
  while (!bytes.empty())
  {
    const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
    if (written > 0)
    {
      bytes.remove_prefix(static_cast<size_t>(written));
    }
    else if (written == 0 || errno != EINTR)
    {
      throw FileError("write", path_, written == 0 ? ENOSPC : errno);
    }
  }
}

void FileHandle::sync() const
{
  while (::fsync(fd_) != 0)
  {
    if (errno == EINVAL || errno == EROFS)  // not a thing that can be synced: a pipe, /dev/null
    {
      return;
    }
    if (errno != EINTR)
    {
      throw FileError("bring to the disk", path_, errno);
    }
  }
}

void FileHandle::close()
{
  const int fd = std::exchange(fd_, -1);
  // After EINTR Linux has closed it all the same: once more would close somebody else's.
  if (fd >= 0 && ::close(fd) != 0 && errno != EINTR)
  {
    throw FileError("close", path_, errno);
  }
}

void syncFolder(const std::filesystem::path& folder)
{
  FileHandle handle("open the folder", folder, O_RDONLY | O_DIRECTORY);
  handle.sync();
}

std::filesystem::path folderOf(const std::filesystem::path& path)
{
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}
}  // namespace traverse::formats
