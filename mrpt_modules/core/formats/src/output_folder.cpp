// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file_handle.h"

#include <traverse/formats/output_folder.h>
#include <traverse/formats/safe_file.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <stdexcept>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace traverse::formats
{
namespace fs = std::filesystem;

namespace
{
/** fs::filesystem_error says it in its own words; ours name the path alike everywhere. */
template <class F>
void naming(const char* action, const fs::path& path, F&& work)
{
  try
  {
    work();
  }
  catch (const fs::filesystem_error& e)
  {
    throw FileError(action, e.path1().empty() ? path : e.path1(), e.code().value());
  }
}

/** Absolute, without a slash at the end, symbolic links of the last part followed. */
fs::path resolved(const fs::path& directory)
{
  fs::path path;
  const auto resolve = [&]
  {
    path = directory.empty() ? directory : fs::absolute(directory).lexically_normal();
    path = path.has_filename() ? path : path.parent_path();
    path = fs::is_symlink(fs::symlink_status(path)) ? fs::weakly_canonical(path) : path;
  };
  naming("find", directory, resolve);
  if (!path.has_filename())
  {
    throw FileError(directory, "cannot be an output folder");
  }
  return path;
}

/** The open folder, locked; fails at once where another holds the lock. */
FileHandle lockedFolder(const fs::path& path, const fs::path& shown)
{
  FileHandle folder("open the folder", path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
  if (::flock(folder.fd(), LOCK_EX | LOCK_NB) != 0)
  {
    if (errno == EWOULDBLOCK)
    {
      throw FileError(shown, "is being written by another run");
    }
    throw FileError("lock", path, errno);
  }
  return folder;
}

/** Between opening and locking, its owner may have renamed or removed it. */
bool isStillAt(const FileHandle& folder, const fs::path& path)
{
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(folder.fd(), &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

void removeContents(const fs::path& folder)
{
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    fs::remove_all(entry.path());
  }
}

/** Files that others wrote into the folder by its path. */
void syncContents(const fs::path& folder)
{
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
  {
    if (entry.is_directory() && !entry.is_symlink())
    {
      syncFolder(entry.path());
    }
    else if (entry.is_regular_file() && !entry.is_symlink())
    {
      FileHandle("open", entry.path(), O_RDONLY).sync();
    }
  }
  syncFolder(folder);
}

/** For file systems that cannot exchange names (some network ones): for a moment there is no DIR.
 * Returns where the old one is now. */
fs::path replaceInTwoSteps(const fs::path& partial, const fs::path& target)
{
  fs::path old = target;
  old += ".old";
  if (::rename(target.c_str(), old.c_str()) != 0)
  {
    throw FileError("move the old folder away", target, errno);
  }
  if (::rename(partial.c_str(), target.c_str()) != 0)
  {
    const int code = errno;
    ::rename(old.c_str(), target.c_str());
    throw FileError("rename to its final name", partial, code);
  }
  return old;
}
}  // namespace

struct OutputFolder::Lock
{
  FileHandle partial;
};

OutputFolder::OutputFolder(const fs::path& directory, Overwrite mode) :
    mode_(mode), final_(resolved(directory)), partial_(final_), lock_(std::make_unique<Lock>())
{
  partial_ += ".partial";
  checkTarget();
  lockPartial();
  naming("clear", partial_, [&] { removeContents(partial_); });
}

OutputFolder::~OutputFolder()
{
  if (lock_->partial.fd() >= 0)  // not committed: the name may be another run's by then
  {
    ::rmdir(partial_.c_str());  // only if nothing was written
  }
}

void OutputFolder::checkTarget() const
{
  const fs::path parent = folderOf(final_);
  naming(
      "look at", final_,
      [&]
      {
        if (!fs::is_directory(parent))
        {
          throw FileError(parent, "is not a folder; the output folder is made in it");
        }
        if (::access(parent.c_str(), W_OK | X_OK) != 0)
        {
          throw FileError("write into", parent, errno);
        }
        if (!fs::exists(fs::symlink_status(final_)))
        {
          return;
        }
        if (!fs::is_directory(final_))
        {
          throw FileError(final_, "is there and is not a folder");
        }
        if (fs::is_empty(final_))
        {
          return;
        }
        if (mode_ == Overwrite::refuse)
        {
          throw FileError(final_, "is there already; --force replaces it");
        }
        if (!fs::exists(final_ / kLastFile))
        {
          throw FileError(
              final_, "is not replaced: it has no metrics.json, so no run of Traverse made it");
        }
      });
}

void OutputFolder::lockPartial()
{
  constexpr int kTries = 100;  // each loses against another run that ends just now
  for (int i = 0; i < kTries; ++i)
  {
    if (::mkdir(partial_.c_str(), 0777) != 0 && errno != EEXIST)
    {
      throw FileError("make the folder", partial_, errno);
    }
    try
    {
      lock_->partial = lockedFolder(partial_, final_);
    }
    catch (const FileError& e)
    {
      if (e.code() == ENOENT)
      {
        continue;
      }
      throw;
    }
    if (isStillAt(lock_->partial, partial_))
    {
      return;
    }
  }
  throw FileError(final_, "is being written by another run");
}

void OutputFolder::write(const std::string& name, std::string_view bytes)
{
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
      name.find('\0') != std::string::npos)
  {
    throw std::invalid_argument("not a plain file name: '" + name + "'");
  }
  const fs::path path = partial_ / name;
  try
  {
    FileHandle file("create", path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    file.write(bytes);
    file.sync();
    file.close();
  }
  catch (const FileError& e)
  {
    if (e.code() == EEXIST)
    {
      throw std::invalid_argument("written twice: '" + path.string() + "'");
    }
    throw;
  }
  last_written_ = name;
}

void OutputFolder::commit()
{
  if (last_written_ != kLastFile)
  {
    throw std::logic_error("OutputFolder: metrics.json has to be the last file");
  }
  naming("bring to the disk", partial_, [&] { syncContents(partial_); });
  // A rename of a folder replaces a missing or an empty one only, so nothing is lost by trying it.
  if (::rename(partial_.c_str(), final_.c_str()) != 0)
  {
    if (errno != ENOTEMPTY && errno != EEXIST)
    {
      throw FileError("rename to its final name", partial_, errno);
    }
    swapWithOld();
  }
  syncFolder(folderOf(final_));
  last_written_.clear();
  lock_->partial = FileHandle();
}

void OutputFolder::swapWithOld()
{
  bool ours = false;
  naming("look at", final_, [&] { ours = fs::exists(final_ / kLastFile); });
  if (mode_ == Overwrite::refuse || !ours)
  {
    throw FileError(final_, "was made by another meanwhile; the results stay in .partial");
  }
  // Held until the old one is gone, so that a next run does not take it for a place to write to.
  const FileHandle old = lockedFolder(final_, final_);
  fs::path outgoing = partial_;
  if (::renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) != 0)
  {
    if (errno != EINVAL && errno != ENOSYS)
    {
      throw FileError("swap with the old folder", partial_, errno);
    }
    outgoing = replaceInTwoSteps(partial_, final_);
  }
  syncFolder(folderOf(final_));
  std::error_code ignored;  // the results are in place; the next run clears what is left
  fs::remove_all(outgoing, ignored);
}
}  // namespace traverse::formats
