// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/safe_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <support/scratch_folder.h>
#include <sys/resource.h>
#include <sys/stat.h>

namespace
{
using namespace traverse::formats;
using ::testing::HasSubstr;
using traverse::testing::ScratchFolder;

template <class F>
std::string errorOf(F&& work)
{
  try
  {
    work();
  }
  catch (const FileError& e)
  {
    return e.what();
  }
  return "";
}

size_t filesIn(const std::filesystem::path& folder)
{
  return static_cast<size_t>(std::distance(
      std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

TEST(SafeFile, GivesBackWhatWasWritten)
{
  const ScratchFolder scratch;
  const std::string bytes("a\0b\r\n\xff", 6);
  writeFile(scratch.path() / "x", "before, and longer");
  writeFile(scratch.path() / "x", bytes);
  EXPECT_EQ(readFile(scratch.path() / "x", 6), bytes);
  EXPECT_EQ(filesIn(scratch.path()), 1U) << "nothing is left beside it";
}

TEST(SafeFile, EmptyFilesAreFiles)
{
  const ScratchFolder scratch;
  writeFile(scratch.path() / "x", "");
  EXPECT_EQ(readFile(scratch.path() / "x", 0), "");
}

TEST(SafeFile, AMissingFolderIsNamedWithTheReason)
{
  const ScratchFolder scratch;
  const std::string error = errorOf([&] { writeFile(scratch.path() / "no" / "x", "y"); });
  EXPECT_THAT(error, HasSubstr((scratch.path() / "no").string()));
  EXPECT_THAT(error, HasSubstr("No such file or directory"));
}

TEST(SafeFile, AFileBeyondTheLimitIsRefusedUnread)
{
  const ScratchFolder scratch;
  writeFile(scratch.path() / "x", "12345");
  EXPECT_THAT(
      errorOf([&] { readFile(scratch.path() / "x", 4); }),
      HasSubstr("has 5 bytes, at most 4 make sense"));
}

TEST(SafeFile, WhatIsNoFileIsRefused)
{
  const ScratchFolder scratch;
  EXPECT_THAT(errorOf([&] { readFile(scratch.path(), 100); }), HasSubstr("is a folder"));
  ASSERT_EQ(::mkfifo((scratch.path() / "fifo").c_str(), 0600), 0);
  EXPECT_THAT(errorOf([&] { readFile(scratch.path() / "fifo", 9); }), HasSubstr("not a file"));
  EXPECT_THAT(errorOf([&] { readFile("/dev/zero", 9); }), HasSubstr("not a file"));
  EXPECT_THAT(errorOf([&] { readFile(scratch.path() / "none", 9); }), HasSubstr("No such file"));
}

TEST(SafeFile, FilesThatSayZeroBytesAreReadToTheirEnd)
{
  EXPECT_THAT(readFile("/proc/self/status", 1U << 20U), HasSubstr("Pid:"));
}

/** The disk is full after so many bytes, for this scope. */
class SmallDisk
{
 public:
  explicit SmallDisk(rlim_t bytes)
  {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }

  ~SmallDisk()
  {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }

  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(SafeFile, WhenTheDiskIsFullTheOldFileStaysAndNothingIsLeftBeside)
{
  const ScratchFolder scratch;
  const std::filesystem::path path = scratch.path() / "x";
  writeFile(path, "old");
  std::string error;
  {
    const SmallDisk disk(1000);
    error = errorOf([&] { writeFile(path, std::string(5000, 'n')); });
  }
  EXPECT_THAT(error, HasSubstr("cannot write"));
  EXPECT_THAT(error, HasSubstr("File too large"));
  EXPECT_EQ(readFile(path, 100), "old");
  EXPECT_EQ(filesIn(scratch.path()), 1U);
}

TEST(SafeFileName, KeepsPlainNames)
{
  EXPECT_EQ(safeFileName("Velodyne1_SCAN-2.x"), "Velodyne1_SCAN-2.x");
}

TEST(SafeFileName, MakesHostileLabelsHarmless)
{
  for (const std::string& label :
       {std::string("../../etc/passwd"), std::string("a/b"), std::string(".."), std::string(""),
        std::string("-rf"), std::string("a\0b", 3), std::string("a\nb"), std::string("<script>"),
        std::string(4096, 'x'), std::string("\xff\xfe")})
  {
    const std::string name = safeFileName(label);
    EXPECT_THAT(name, ::testing::MatchesRegex("[A-Za-z0-9_][A-Za-z0-9._-]+")) << label;
    EXPECT_LE(name.size(), 80U);
  }
}

TEST(SafeFileName, DifferentLabelsGetDifferentNames)
{
  EXPECT_NE(safeFileName("a/b"), safeFileName("a_b"));
  EXPECT_NE(safeFileName("a/b"), safeFileName("a:b"));
  EXPECT_NE(safeFileName(std::string(200, 'x') + "1"), safeFileName(std::string(200, 'x') + "2"));
}
}  // namespace
