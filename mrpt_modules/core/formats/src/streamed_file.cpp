// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file_handle.h"

#include <traverse/formats/safe_file.h>
#include <traverse/formats/streamed_file.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace traverse::formats
{
struct StreamedFile::State
{
  std::filesystem::path final;
  std::filesystem::path partial;
  FileHandle file;
  bool renamed = false;
};

namespace
{
/** Opened without truncating: another run may be writing to it. */
FileHandle openLocked(const std::filesystem::path& partial)
{
  FileHandle file("create", partial, O_WRONLY | O_CREAT | O_NOFOLLOW | O_NONBLOCK);
  if (::flock(file.fd(), LOCK_EX | LOCK_NB) != 0)
  {
    throw FileError(partial, "is being written by another run");
  }
  struct stat opened = {};
  struct stat named = {};
  if (::fstat(file.fd(), &opened) != 0 || ::stat(partial.c_str(), &named) != 0 ||
      opened.st_ino != named.st_ino)
  {
    throw FileError(partial, "was taken away by another run; try again");
  }
  if (!S_ISREG(opened.st_mode))
  {
    throw FileError(partial, "is not a file");
  }
  if (::ftruncate(file.fd(), 0) != 0)
  {
    throw FileError("empty", partial, errno);
  }
  return file;
}
}  // namespace

StreamedFile::StreamedFile(const std::filesystem::path& path) : state_(std::make_unique<State>())
{
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
  {
    throw FileError(path, "is a folder, not a file");
  }
  state_->final = path;
  state_->partial = path.string() + ".partial";
  state_->file = openLocked(state_->partial);
}

StreamedFile::~StreamedFile()
{
  if (!state_->renamed)
  {
    ::unlink(state_->partial.c_str());
  }
}

void StreamedFile::write(std::string_view bytes)
{
  state_->file.write(bytes);
  size_ += bytes.size();
}

void StreamedFile::finish()
{
  state_->file.sync();
}

void StreamedFile::commit()
{
  if (::rename(state_->partial.c_str(), state_->final.c_str()) != 0)
  {
    throw FileError("replace", state_->final, errno);
  }
  state_->renamed = true;
  state_->file.close();
  syncFolder(folderOf(state_->final));
}
}  // namespace traverse::formats
