// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file_handle.h"

#include <traverse/formats/checksum.h>
#include <traverse/formats/safe_file.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace traverse::formats
{
namespace
{
/** Of this process and call, so that two writers of one file never share it. */
std::filesystem::path temporaryBeside(const std::filesystem::path& path)
{
  static std::atomic<unsigned> calls = 0;
  return folderOf(path) /
         fmt::format(".{}.{}-{}.tmp", path.filename().string(), ::getpid(), calls++);
}

/** Removes the temporary file unless it became the real one. */
struct Temporary
{
  std::filesystem::path path;
  bool keep = false;

  ~Temporary()
  {
    if (!keep)
    {
      ::unlink(path.c_str());
    }
  }
};

bool isPlain(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-';
}
}  // namespace

FileError::FileError(const std::string& action, const std::filesystem::path& path, int code) :
    std::runtime_error(fmt::format(
        "cannot {} '{}': {}", action, path.string(), std::generic_category().message(code))),
    code_(code)
{
}

FileError::FileError(const std::filesystem::path& path, const std::string& problem) :
    std::runtime_error(fmt::format("'{}' {}", path.string(), problem))
{
}

void writeFile(const std::filesystem::path& path, std::string_view bytes)
{
  Temporary temporary{temporaryBeside(path)};
  FileHandle file("create", temporary.path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
  file.write(bytes);
  file.sync();
  file.close();
  if (::rename(temporary.path.c_str(), path.c_str()) != 0)
  {
    throw FileError("replace", path, errno);
  }
  temporary.keep = true;
  syncFolder(folderOf(path));
}

std::string readFile(const std::filesystem::path& path, size_t max_bytes)
{
  const FileHandle file("open", path, O_RDONLY | O_NONBLOCK);  // a fifo must not make us wait
  struct stat status = {};
  if (::fstat(file.fd(), &status) != 0)
  {
    throw FileError("look at", path, errno);
  }
  if (!S_ISREG(status.st_mode))
  {
    throw FileError(path, S_ISDIR(status.st_mode) ? "is a folder, not a file" : "is not a file");
  }
  std::string bytes;
  const auto too_long = [&](size_t size)
  { return FileError(path, fmt::format("has {} bytes, at most {} make sense", size, max_bytes)); };
  if (static_cast<size_t>(status.st_size) > max_bytes)
  {
    throw too_long(static_cast<size_t>(status.st_size));
  }
  bytes.resize(static_cast<size_t>(status.st_size) + 1);  // one more: the end is seen, not believed
  size_t size = 0;
  while (true)
  {
    const ssize_t got = ::read(file.fd(), bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno != EINTR)
    {
      throw FileError("read", path, errno);
    }
    if (got == 0)
    {
      break;
    }
    size += static_cast<size_t>(std::max<ssize_t>(got, 0));
    if (size > max_bytes)
    {
      throw too_long(size);
    }
    if (size == bytes.size())  // it grew, or says 0 like those of /proc
    {
      bytes.resize(std::min(2 * size + 4096, max_bytes + 1));
    }
  }
  bytes.resize(size);
  return bytes;
}

std::string safeFileName(std::string_view untrusted_label)
{
  constexpr size_t kLongest = 70;
  std::string name(untrusted_label.substr(0, kLongest));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !isPlain(c); }, '_');
  if (name.empty() || name.front() == '.' || name.front() == '-')
  {
    name.insert(0, 1, '_');
  }
  return name == untrusted_label ? name : fmt::format("{}-{:08x}", name, crc32(untrusted_label));
}
}  // namespace traverse::formats
