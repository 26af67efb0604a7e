// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records @foxglove/velodyne-cloud's output again, from npm, and compares it with the files that
// velodyne_cloud_test trusts. Slow: it needs node, npm and a registry.
#include "support/data.h"
#include "support/velodyne_capture.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace
{
std::filesystem::path recordedFile(const std::string& name)
{
  return std::filesystem::path(TRAVERSE_SOURCE_DIR) / "tests/oracle/velodyne_cloud" / name;
}

bool runs(const std::string& command)
{
  return std::system(command.c_str()) == 0;
}

class Rerecording : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    if (!runs("node --version >/dev/null 2>&1") || !runs("npm --version >/dev/null 2>&1"))
    {
      GTEST_SKIP() << "SKIPPED: node and npm are needed to record the oracle again";
    }
    std::filesystem::create_directories(folder_);
    const std::string install =
        "cd " + folder_.string() +
        " && npm init -y >/dev/null && npm install @foxglove/velodyne-cloud@1.0.1 >npm.log 2>&1";
    if (!runs(install))
    {
      GTEST_SKIP() << "SKIPPED: npm cannot install @foxglove/velodyne-cloud 1.0.1 here";
    }
  }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  void expectRecorded(const std::filesystem::path& input, int every, const std::string& recorded)
  {
    TRAVERSE_NEEDS(input);
    const std::string command = "cd " + folder_.string() + " && node " +
                                recordedFile("record.js").string() + " " + std::to_string(every) +
                                " '" + input.string() + "' " + recorded;
    ASSERT_TRUE(runs(command)) << command;
    const auto now = traverse::testing::bytesOf(folder_ / recorded);
    ASSERT_GT(now.size(), 1000U);
    EXPECT_TRUE(now == traverse::testing::bytesOf(recordedFile(recorded))) << recorded;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("traverse_rerecord_" + std::to_string(::getpid()));
};

TEST_F(Rerecording, OfDebiansScanGivesTheRecordedFile)
{
  expectRecorded(
      traverse::testing::mrptData("test_velodyne_VLP16.rawlog"), 1, "debian_vlp16.csv.gz");
}

TEST_F(Rerecording, OfTheCapturesGivesTheRecordedFiles)
{
  const auto captures = traverse::testing::sharedData("velodyne-pcap");
  expectRecorded(captures / "sample_velodyne_vlp16_gps.pcap", 1200, "sample_vlp16.csv");
  expectRecorded(captures / "sample_velodyne_hdl32.pcap", 2400, "sample_hdl32e.csv");
  expectRecorded(captures / "nebula_vlp32c_front.pcap.gz", 2100, "nebula_vlp32c.csv");
}
}  // namespace
