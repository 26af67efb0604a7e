// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <support/data.h>
#include <support/log_damage.h>

namespace
{
using traverse::testing::readText;
using traverse::testing::unpacked;

class RealLogDamage : public ::testing::TestWithParam<const char*>
{
};

TEST_P(RealLogDamage, IsToldAndCrashesNothing)
{
  const std::string file = traverse::testing::mrptData(GetParam());
  TRAVERSE_NEEDS(file);
  const std::string packed = readText(file);
  traverse::testing::damageGzip(packed, 11, 60);
  traverse::testing::damagePlain(unpacked(packed), 12, 60);
  EXPECT_LT(traverse::testing::peakMebibytes(), 1500);
}

INSTANTIATE_TEST_SUITE_P(
    Debian,
    RealLogDamage,
    ::testing::Values(
        "test_velodyne_VLP16.rawlog",
        "tests_rgbd.rawlog",
        "localization_demo.rawlog",
        "rot_scan_velodyne.rawlog",
        "test_rtk_path.rawlog"));

TEST(LogDamageSlow, EveryMalformedFileIsNoLog)
{
  const std::filesystem::path folder = traverse::testing::sharedData("malformed");
  TRAVERSE_NEEDS(folder);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file() && entry.file_size() > 0)
    {
      const auto r = traverse::testing::readDamaged(readText(entry.path()));
      EXPECT_FALSE(r.report.complete()) << entry.path();
    }
  }
}
}  // namespace
