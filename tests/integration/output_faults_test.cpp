// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An output folder is replaced by a child that is killed, or whose system call fails, at its 1st,
// 2nd, 3rd ... system call on files, until the run gets by without reaching the fault.
#include <traverse/formats/output_folder.h>
#include <traverse/formats/safe_file.h>

#include <gtest/gtest.h>

#include <cerrno>
#include <support/scratch_folder.h>
#include <support/syscall_faults.h>

namespace
{
namespace fs = std::filesystem;
using namespace traverse::formats;
using namespace traverse::testing;

constexpr int kSaidSo = 3;
constexpr int kSaidItWrong = 4;
constexpr int kMostCalls = 1000;

#if defined(__x86_64__)
/** Writes a generation of results; the exit code of a program that does so. */
int writeResults(const fs::path& directory, char generation)
{
  try
  {
    OutputFolder out(directory, Overwrite::replace);
    out.write("a.tif", std::string(9000, generation));
    out.write("b.tif", std::string(10, generation));
    out.write("metrics.json", std::string(1, generation));
    out.commit();
    return 0;
  }
  catch (const FileError&)
  {
    return kSaidSo;
  }
  catch (const std::exception&)
  {
    return kSaidItWrong;
  }
}

/** The generation that a reader finds; '?' where it finds a mix or a part. */
char generationIn(const fs::path& directory)
{
  const std::string metrics = readFile(directory / "metrics.json", 10);
  const char generation = metrics.empty() ? '?' : metrics[0];
  const bool whole = readFile(directory / "a.tif", 10000) == std::string(9000, generation) &&
                     readFile(directory / "b.tif", 10000) == std::string(10, generation);
  return whole ? generation : '?';
}

TEST(OutputFaults, KilledAtAnySystemCallAReaderSeesTheOldOrTheNewResults)
{
  const ScratchFolder scratch;
  const fs::path directory = scratch.path() / "out";
  ASSERT_EQ(writeResults(directory, 'o'), 0);
  bool seen_new = false;
  int n = 0;
  for (; n < kMostCalls; ++n)
  {
    ASSERT_EQ(writeResults(directory, 'o'), 0) << "what the killed one left does not matter";
    const FaultRun run = runWithFault({n, 0}, [&] { return writeResults(directory, 'n'); });
    const char generation = generationIn(directory);
    ASSERT_TRUE(generation == 'o' || generation == 'n') << "killed at call " << n;
    ASSERT_FALSE(seen_new && generation == 'o') << "one moment divides old from new";
    seen_new = generation == 'n';
    if (!run.reached)
    {
      ASSERT_EQ(run.exit_code, 0);
      break;
    }
  }
  EXPECT_GT(n, 20) << "the faults were where we think";
  EXPECT_LT(n, kMostCalls);
}

void failEverywhereWith(int error)
{
  const ScratchFolder scratch;
  const fs::path directory = scratch.path() / "out";
  int n = 0;
  int said_so = 0;
  for (; n < kMostCalls; ++n)
  {
    ASSERT_EQ(writeResults(directory, 'o'), 0);
    const FaultRun run = runWithFault({n, error}, [&] { return writeResults(directory, 'n'); });
    const char generation = generationIn(directory);
    ASSERT_TRUE(run.exit_code == 0 || run.exit_code == kSaidSo) << "at call " << n;
    ASSERT_TRUE(generation == 'n' || (generation == 'o' && run.exit_code == kSaidSo))
        << "at call " << n << ": exit code " << run.exit_code << ", results " << generation;
    said_so += static_cast<int>(run.exit_code == kSaidSo);
    if (!run.reached)
    {
      break;
    }
  }
  EXPECT_GT(said_so, 20);
  EXPECT_LT(n, kMostCalls);
}

TEST(OutputFaults, AFullDiskAtAnySystemCallIsSaidAndLeavesTheOldResults)
{
  failEverywhereWith(ENOSPC);
}

TEST(OutputFaults, AnIoErrorAtAnySystemCallIsSaidAndLeavesTheOldResults)
{
  failEverywhereWith(EIO);
}

TEST(OutputFaults, ARefusalAtAnySystemCallIsSaidAndLeavesTheOldResults)
{
  failEverywhereWith(EACCES);
}

TEST(OutputFaults, AFileIsOldOrNewWhereverItsWriterIsKilled)
{
  const ScratchFolder scratch;
  const fs::path path = scratch.path() / "x";
  int n = 0;
  for (; n < kMostCalls; ++n)
  {
    writeFile(path, "old");
    const auto work = [&]
    {
      writeFile(path, std::string(9000, 'n'));
      return 0;
    };
    const FaultRun run = runWithFault({n, 0}, work);
    const std::string bytes = readFile(path, 10000);
    ASSERT_TRUE(bytes == "old" || bytes == std::string(9000, 'n')) << "killed at call " << n;
    if (!run.reached)
    {
      break;
    }
  }
  EXPECT_GT(n, 5);
}
#endif
}  // namespace
