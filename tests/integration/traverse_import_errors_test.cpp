// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// What traverse-import says and leaves behind where something is wrong.
#include <traverse/formats/safe_file.h>
#include <traverse/importing/log_writer.h>
#include <traverse/observations/convert.h>

#include <mrpt/maps/CPointsMapXYZI.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <support/log_reading.h>
#include <support/syscall_faults.h>
#include <support/traverse_import.h>
#include <thread>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/** A cloud of two points, as text. */
std::string smallPcd(double first_time_s)
{
  return "FIELDS x y z ring time\nSIZE 4 4 4 2 8\nTYPE F F F U F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n"
         "1 2 3 0 " +
         std::to_string(first_time_s) + "\n4 5 6 1 " + std::to_string(first_time_s + 0.05) + "\n";
}

class TraverseImportErrors : public ::testing::Test
{
 protected:
  TraverseImportErrors()
  {
    fs::create_directory(input_);
    for (int i = 0; i < 3; ++i)
    {
      writeText(input_ / (std::to_string(i) + ".pcd"), smallPcd(1.6e9 + i));
    }
  }

  ScratchFolder scratch_;
  fs::path input_ = scratch_ / "clouds";
  fs::path log_ = scratch_ / "made.rawlog";
  fs::path side_ = formats::channelsFileOf(log_);
};

TEST_F(TraverseImportErrors, WrongUsageIsExitTwo)
{
  EXPECT_EQ(run({importProgram()}).exit_code, 2);
  EXPECT_EQ(traverseImport(input_, log_, {"--format", "no-such"}).exit_code, 2);
  EXPECT_EQ(traverseImport(input_, log_, {"--sensor-pose", "1,2,3"}).exit_code, 2);
  EXPECT_EQ(traverseImport(input_, log_, {"--start-time", "0"}).exit_code, 2);
  const fs::path pcd = input_ / "0.pcd";
  EXPECT_EQ(traverseImport(pcd, pcd, {"--force"}).exit_code, 2) << "it would replace its input";
  EXPECT_EQ(run({importProgram(), "--help"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(log_));
}

TEST_F(TraverseImportErrors, InputThatIsNoneIsExitFour)
{
  fs::create_directory(scratch_ / "empty");
  writeText(scratch_ / "text.pcd", "this is no cloud\n");
  writeText(scratch_ / "text.pcap", "this is no capture\n");
  for (const fs::path& input :
       {scratch_ / "missing", scratch_ / "empty", scratch_ / "text.pcd", scratch_ / "text.pcap"})
  {
    const Finished ran = traverseImport(input, log_);
    EXPECT_EQ(ran.exit_code, 4) << input << ran.err;
    EXPECT_THAT(ran.err, HasSubstr(input.filename().string()));
    EXPECT_FALSE(fs::exists(log_)) << "no log without anything in it";
    EXPECT_FALSE(fs::exists(log_.string() + ".partial"));
  }
}

TEST_F(TraverseImportErrors, ALogThatIsThereNeedsForce)
{
  writeText(log_, "somebody's own");
  const Finished ran = traverseImport(input_, log_);
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_THAT(ran.err, HasSubstr("--force"));
  EXPECT_EQ(readText(log_), "somebody's own");
  EXPECT_EQ(traverseImport(input_, log_, {"--force"}).exit_code, 0);
  EXPECT_EQ(readLog(log_).report.channels.at("attached"), 3U);
}

TEST_F(TraverseImportErrors, DamagedPartsAreLeftOutAndNamed)
{
  writeText(input_ / "1.pcd", smallPcd(1.6e9).substr(0, 100));
  const Finished ran = traverseImport(input_, log_);
  EXPECT_EQ(ran.exit_code, 5) << ran.err;
  EXPECT_THAT(ran.err, AllOf(HasSubstr("damaged"), HasSubstr("1.pcd")));
  EXPECT_EQ(readLog(log_).scans.size(), 2U);
}

TEST_F(TraverseImportErrors, ALogWithoutChannelsTakesOldOnesAway)
{
  ASSERT_EQ(traverseImport(input_, log_).exit_code, 0);
  ASSERT_TRUE(fs::exists(side_));
  writeText(scratch_ / "plain.bin", std::string(32, '\1'));
  ASSERT_EQ(traverseImport(scratch_ / "plain.bin", log_, {"--force"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(side_));
}

TEST_F(TraverseImportErrors, HostileNamesAreShownHarmless)
{
  writeText(input_ / "x\33[2J\n.pcd", "FIELDS nothing\n");
  const Finished ran = traverseImport(input_, log_, {"--sensor-label", "a\nb\33"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_EQ((ran.out + ran.err).find('\33'), std::string::npos);
}

TEST_F(TraverseImportErrors, PicturesThatAreNoneAreDamage)
{
  TRAVERSE_NEEDS(sharedData("malformed/png"));
  for (const char* name : {"badcrc.png", "huge_IDAT.png", "bad_iCCP.png"})
  {
    fs::copy(
        sharedData("malformed/png") / name,
        scratch_ / ("frame-" + std::string(name) + ".depth.png"));
  }
  writeText(
      scratch_ / "frame-99.depth.png",
      std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff\x10\0\0\0\0", 29));
  const Finished ran = traverseImport(scratch_.path(), log_);
  EXPECT_EQ(ran.exit_code, 4) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("frame-99.depth.png: is no PNG or JPEG"));
}

TEST_F(TraverseImportErrors, AFullDiskKeepsTheOldLog)
{
  const fs::path disk = scratch_ / "disk";
  fs::create_directory(disk);
  std::string points;
  for (int i = 0; i < 200'000; ++i)
  {
    points += std::to_string(i % 977) + "." + std::to_string(i * 7919 % 100000) + " 1 2\n";
  }
  writeText(
      scratch_ / "large.pcd",
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 200000\nHEIGHT 1\nDATA ascii\n" + points);
  const std::string quoted = "'" + disk.string() + "'";
  const Finished ran = run(
      {"unshare", "--mount", "--map-root-user", "sh", "-c",
       "mount -t tmpfs -o size=200k none " + quoted + " && echo old > " + quoted +
           "/made.rawlog && '" + importProgram() + "' '" + (scratch_ / "large.pcd").string() +
           "' --force --output " + quoted + "/made.rawlog; echo code $?; cat " + quoted +
           "/made.rawlog; ls -A " + quoted});
  if (ran.err.find("traverse-import") == std::string::npos)
  {
    GTEST_SKIP() << "SKIPPED: no mounts here: " << ran.err;
  }
  EXPECT_THAT(ran.err, HasSubstr("No space left"));
  EXPECT_EQ(ran.out, "code 1\nold\nmade.rawlog\n");
}

TEST_F(TraverseImportErrors, AnInterruptionSavesWhatIsDone)
{
  const fs::path input = sharedData("rgbd-redkitchen");
  TRAVERSE_NEEDS(input);
  Process program({importProgram(), input.string(), "--output", log_.string()});
  // Until it writes; then there are seconds left to interrupt it.
  for (int i = 0; i < 1000 && (!fs::exists(log_.string() + ".partial") ||
                               fs::file_size(log_.string() + ".partial") < 500'000);
       ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  program.signal(SIGINT);
  const Finished ran = program.wait(std::chrono::seconds(60));
  EXPECT_EQ(ran.exit_code, 130) << ran.err;
  const LogReading reading = readLog(log_);
  EXPECT_TRUE(reading.report.complete());
  EXPECT_GT(reading.scans.size(), 0U);
  EXPECT_LT(reading.scans.size(), 50U);
}

#if defined(__x86_64__)
constexpr int kSaidSo = 3;

/** Writes a log of one cloud, which tells the generation. */
int writeGeneration(const fs::path& log, float generation)
{
  auto cloud = mrpt::obs::CObservationPointCloud::Create();
  cloud->timestamp = observations::toTimePoint(kLogStart);
  cloud->sensorLabel = "TOP";
  auto points = mrpt::maps::CPointsMapXYZI::Create();
  points->insertPointRGB(generation, 0, 1, 1, 1, 1);
  cloud->pointcloud = points;
  try
  {
    importing::LogWriter writer(log, true);
    writer.add({cloud, {{7}, {generation / 100}}});
    writer.commit();
    return 0;
  }
  catch (const formats::FileError&)
  {
    return kSaidSo;
  }
}

/** The generation that a reader finds, with its own channels; 0 where they are lost or mixed. */
float generationOf(const fs::path& log)
{
  const LogReading reading = readLog(log);
  if (!reading.report.complete() || reading.scans.size() != 1)
  {
    return 0;
  }
  const points::ScanBuffer& scan = reading.scans[0].scan;
  const bool none = scan.time_s.empty();
  const bool own = !none && scan.time_s[0] == scan.x[0] / 100;
  return own || (none && scan.x[0] == 1) ? scan.x[0] : 0;
}

void expectOldOrNew(int error)
{
  const ScratchFolder scratch;
  const fs::path log = scratch / "a.rawlog";
  bool reached = true;
  for (int at = 0; reached && at < 200; ++at)
  {
    ASSERT_EQ(writeGeneration(log, 1), 0);
    const FaultRun ran = runWithFault({at, error}, [&] { return writeGeneration(log, 2); });
    reached = ran.reached;
    const float found = generationOf(log);
    ASSERT_TRUE(found == 1 || found == 2) << "call " << at;
    ASSERT_TRUE(error == 0 || ran.exit_code == 0 || ran.exit_code == kSaidSo) << "call " << at;
    ASSERT_TRUE(ran.exit_code != 0 || found == 2) << "it said it is done, call " << at;
  }
  EXPECT_FALSE(reached) << "the last run gets by";
}

TEST(ImportFaults, KilledAtAnySystemCallTheLogIsTheOldOrTheNewWithItsChannels)
{
  expectOldOrNew(0);
}

TEST(ImportFaults, AnySystemCallThatFailsIsToldOrHarmless)
{
  expectOldOrNew(ENOSPC);
}
#endif
}  // namespace
