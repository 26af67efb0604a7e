// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/output_folder.h>
#include <traverse/formats/safe_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <support/scratch_folder.h>
#include <sys/file.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using namespace traverse::formats;
using ::testing::HasSubstr;
using traverse::testing::ScratchFolder;

void run(const fs::path& directory, const std::string& content, Overwrite mode = Overwrite::refuse)
{
  OutputFolder out(directory, mode);
  out.write("map.tif", content);
  out.write("metrics.json", "{}");
  out.commit();
}

std::string errorOf(const fs::path& directory, Overwrite mode = Overwrite::refuse)
{
  try
  {
    const OutputFolder out(directory, mode);
  }
  catch (const FileError& e)
  {
    return e.what();
  }
  return "";
}

std::string content(const fs::path& file)
{
  return readFile(file, 100);
}

TEST(OutputFolder, TakesItsNameAtTheEnd)
{
  const ScratchFolder scratch;
  const fs::path directory = scratch.path() / "out";
  OutputFolder out(directory, Overwrite::refuse);
  EXPECT_EQ(out.path(), scratch.path() / "out.partial");
  out.write("map.tif", "bytes");
  EXPECT_FALSE(fs::exists(directory));
  out.write("metrics.json", "{}");
  out.commit();
  EXPECT_EQ(content(directory / "map.tif"), "bytes");
  EXPECT_FALSE(fs::exists(out.path()));
}

TEST(OutputFolder, IsNotReplacedUnlessAsked)
{
  const ScratchFolder scratch;
  run(scratch.path() / "out", "old");
  EXPECT_THAT(errorOf(scratch.path() / "out"), HasSubstr("is there already; --force"));
  EXPECT_EQ(content(scratch.path() / "out" / "map.tif"), "old");
  EXPECT_FALSE(fs::exists(scratch.path() / "out.partial"));
}

TEST(OutputFolder, IsReplacedAsAWhole)
{
  const ScratchFolder scratch;
  run(scratch.path() / "out", "old");
  std::ofstream(scratch.path() / "out" / "extra") << "x";
  run(scratch.path() / "out/", "new", Overwrite::replace);
  EXPECT_EQ(content(scratch.path() / "out" / "map.tif"), "new");
  EXPECT_FALSE(fs::exists(scratch.path() / "out" / "extra"));
  EXPECT_FALSE(fs::exists(scratch.path() / "out.partial"));
}

TEST(OutputFolder, NeverReplacesAFolderThatNoRunMade)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "home");
  std::ofstream(scratch.path() / "home" / "thesis.tex") << "x";
  EXPECT_THAT(
      errorOf(scratch.path() / "home", Overwrite::replace), HasSubstr("no run of Traverse"));
  EXPECT_TRUE(fs::exists(scratch.path() / "home" / "thesis.tex"));
}

TEST(OutputFolder, AnEmptyFolderMayBeUsed)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "out");
  run(scratch.path() / "out", "new");
  EXPECT_EQ(content(scratch.path() / "out" / "map.tif"), "new");
}

TEST(OutputFolder, ReplacesWhatAKilledRunLeft)
{
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "out.partial" / "deep");
  std::ofstream(scratch.path() / "out.partial" / "deep" / "stale") << "x";
  run(scratch.path() / "out", "new");
  EXPECT_FALSE(fs::exists(scratch.path() / "out" / "deep"));
}

TEST(OutputFolder, RefusesASecondWriter)
{
  const ScratchFolder scratch;
  OutputFolder first(scratch.path() / "out", Overwrite::refuse);
  first.write("map.tif", "first");
  EXPECT_THAT(errorOf(scratch.path() / "out"), HasSubstr("being written by another run"));
  EXPECT_THAT(
      errorOf(scratch.path() / "out", Overwrite::replace), HasSubstr("being written by another"));
  EXPECT_EQ(content(first.path() / "map.tif"), "first");
}

TEST(OutputFolder, ANextRunMayStartAsSoonAsOneHasEnded)
{
  const ScratchFolder scratch;
  OutputFolder first(scratch.path() / "out", Overwrite::refuse);
  first.write("metrics.json", "1");
  first.commit();
  run(scratch.path() / "out", "second", Overwrite::replace);
  EXPECT_EQ(content(scratch.path() / "out" / "map.tif"), "second");
}

TEST(OutputFolder, TheEndOfOneRunLeavesTheFolderOfTheNextAlone)
{
  const ScratchFolder scratch;
  auto first = std::make_optional<OutputFolder>(scratch.path() / "out", Overwrite::refuse);
  first->write("metrics.json", "1");
  first->commit();
  OutputFolder second(scratch.path() / "out", Overwrite::replace);
  first.reset();
  EXPECT_NO_THROW(second.write("map.tif", "x"));
}

TEST(OutputFolder, WhatAnotherRunMadeMeanwhileIsKept)
{
  const ScratchFolder scratch;
  OutputFolder out(scratch.path() / "out", Overwrite::refuse);
  out.write("metrics.json", "ours");
  fs::create_directory(scratch.path() / "out");
  std::ofstream(scratch.path() / "out" / "metrics.json") << "theirs";
  EXPECT_THROW(out.commit(), FileError);
  EXPECT_EQ(content(scratch.path() / "out" / "metrics.json"), "theirs");
  EXPECT_EQ(content(scratch.path() / "out.partial" / "metrics.json"), "ours");
}

TEST(OutputFolder, ChecksTheParentBeforeAnythingRuns)
{
  const ScratchFolder scratch;
  EXPECT_THAT(errorOf(scratch.path() / "no" / "out"), HasSubstr("is not a folder"));
  std::ofstream(scratch.path() / "file") << "x";
  EXPECT_THAT(errorOf(scratch.path() / "file" / "out"), HasSubstr("is not a folder"));
  EXPECT_THAT(errorOf(scratch.path() / "file"), HasSubstr("is not a folder"));
  EXPECT_THAT(errorOf("/"), HasSubstr("cannot be an output folder"));
  EXPECT_THAT(errorOf(""), HasSubstr("cannot be an output folder"));
}

TEST(OutputFolder, AReadOnlyParentIsRefusedBeforeAnythingRuns)
{
  EXPECT_THAT(errorOf("/proc/out"), HasSubstr("/proc"));
  EXPECT_NE(errorOf("/sys/kernel/out"), "");
}

TEST(OutputFolder, FollowsALinkToWhereResultsAreKept)
{
  const ScratchFolder scratch;
  run(scratch.path() / "big", "old");
  fs::create_symlink(scratch.path() / "big", scratch.path() / "out");
  run(scratch.path() / "out", "new", Overwrite::replace);
  EXPECT_TRUE(fs::is_symlink(scratch.path() / "out"));
  EXPECT_EQ(content(scratch.path() / "big" / "map.tif"), "new");
}

TEST(OutputFolder, DoesNotWriteThroughAPlantedLink)
{
  const ScratchFolder scratch;
  fs::create_directory(scratch.path() / "victim");
  std::ofstream(scratch.path() / "victim" / "keep") << "x";
  fs::create_directory_symlink(scratch.path() / "victim", scratch.path() / "out.partial");
  EXPECT_NE(errorOf(scratch.path() / "out"), "");
  EXPECT_TRUE(fs::exists(scratch.path() / "victim" / "keep"));
}

TEST(OutputFolder, TakesPlainNamesOnlyAndEachOnce)
{
  const ScratchFolder scratch;
  OutputFolder out(scratch.path() / "out", Overwrite::refuse);
  for (const std::string name : {"", ".", "..", "../x", "a/b", "/etc/x"})
  {
    EXPECT_THROW(out.write(name, ""), std::invalid_argument) << name;
  }
  EXPECT_THROW(out.write(std::string("a\0b", 3), ""), std::invalid_argument);
  out.write("x", "1");
  EXPECT_THROW(out.write("x", "2"), std::invalid_argument);
}

TEST(OutputFolder, MetricsComeLast)
{
  const ScratchFolder scratch;
  OutputFolder out(scratch.path() / "out", Overwrite::refuse);
  EXPECT_THROW(out.commit(), std::logic_error);
  out.write("metrics.json", "{}");
  out.write("late", "x");
  EXPECT_THROW(out.commit(), std::logic_error);
}

TEST(OutputFolder, LeavesNothingWhereNothingWasWritten)
{
  const ScratchFolder scratch;
  {
    const OutputFolder out(scratch.path() / "out", Overwrite::refuse);
  }
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}
}  // namespace
