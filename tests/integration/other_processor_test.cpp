// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The same bytes where the C library takes other code: as on a processor without FMA and AVX2.
#include "support/driven_velodyne.h"
#include "support/traverse_map.h"

#include <traverse/formats/checksum.h>
#include <traverse/poses/pose_track.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

namespace
{
using namespace traverse;
using namespace traverse::testing;

const std::string kPlain = "GLIBC_TUNABLES=";
const std::string kOther = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2";

template <class T>
uint32_t checksum(const std::vector<T>& values)
{
  return formats::crc32({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

/** Of what this process computes; printed for a parent that set another environment. */
std::string sums()
{
  std::vector<double> library;
  std::vector<double> ours;
  std::mt19937_64 random(51);
  std::uniform_real_distribution<double> any(-3, 3);
  const auto pose = [&]
  {
    Eigen::Quaterniond q(any(random), any(random), any(random), any(random));
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = q.normalized().toRotationMatrix();
    T.translation() = Eigen::Vector3d(any(random), any(random), any(random));
    return T;
  };
  for (int i = 0; i < 50'000; ++i)
  {
    const double x = any(random);
    library.insert(library.end(), {std::sin(x), std::cos(x), std::atan2(x, 1.3)});
    const Eigen::Isometry3d T = poses::interpolate(pose(), pose(), x);
    ours.insert(ours.end(), T.matrix().data(), T.matrix().data() + 16);
  }
  return "library " + std::to_string(checksum(library)) + " ours " + std::to_string(checksum(ours));
}

/** What stands behind `word` in the sums of a process with that environment. */
std::string sumIn(const std::string& environment, const std::string& word)
{
  const Finished ran =
      run({"/proc/self/exe", "--gtest_filter=DISABLED_OtherProcessor.Prints",
           "--gtest_also_run_disabled_tests"},
          {environment});
  const size_t at = ran.out.find(word + " ");
  const size_t from = at + word.size() + 1;
  return at == std::string::npos ? ""
                                 : ran.out.substr(from, ran.out.find_first_of(" \n", from) - from);
}

TEST(DISABLED_OtherProcessor, Prints)
{
  std::cout << sums() << "\n";
}

/** A test that compares nothing would pass. */
#define NEEDS_ANOTHER_LIBRARY()                                                      \
  do                                                                                 \
  {                                                                                  \
    ASSERT_NE(sumIn(kPlain, "library"), "");                                         \
    if (sumIn(kPlain, "library") == sumIn(kOther, "library"))                        \
    {                                                                                \
      GTEST_SKIP() << "SKIPPED: " << kOther << " changes nothing on this processor"; \
    }                                                                                \
  } while (false)

TEST(OtherProcessor, GivesTheSamePoses)
{
  NEEDS_ANOTHER_LIBRARY();
  EXPECT_EQ(sumIn(kPlain, "ours"), sumIn(kOther, "ours"));
}

void expectSameArchive(
    const std::string& config,
    const std::vector<std::string>& settings,
    const std::string& log = "")
{
  const ScratchFolder scratch;
  std::vector<std::string> arguments = {config, "--quiet", "--set", "traverse-map.pictures=false"};
  for (const std::string& setting : settings)
  {
    arguments.insert(arguments.end(), {"--set", setting});
  }
  if (!log.empty())
  {
    arguments.insert(arguments.end(), {"--rawlog", log});
  }
  for (const auto& [folder, environment] : {std::pair{"plain", kPlain}, std::pair{"other", kOther}})
  {
    std::vector<std::string> here = arguments;
    here.insert(here.end(), {"--output", scratch / folder});
    const Finished ran = traverseMap(here, {"DISPLAY=", environment});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }
  EXPECT_EQ(
      readText(scratch / "plain" / "map.traverse"), readText(scratch / "other" / "map.traverse"));
}

TEST(OtherProcessor, GivesTheSameMapOfADrivenVelodyne)
{
  NEEDS_ANOTHER_LIBRARY();
  const ScratchFolder scratch;
  writeText(scratch / "bend.rawlog", drivenVelodyneLog({0.1, 0.4, 0.7, 1.0, 1.3, 1.6, 1.9, 2.2}));
  expectSameArchive(
      ini("vlp16"),
      {"Poses.source=robot_pose", "Maps_CTraversabilityGridMap_00_insertOpts.extent=growing"},
      scratch / "bend.rawlog");
}

TEST(OtherProcessor, GivesTheSameMapOfAnRgbdFrame)
{
  NEEDS_ANOTHER_LIBRARY();
  expectSameArchive(ini("rgbd"), {});
}

TEST(OtherProcessor, GivesTheSameMapOfALaserDrive)
{
  NEEDS_ANOTHER_LIBRARY();
  expectSameArchive(
      ini("laser2d"),
      {"Poses.source=odometry", "Maps_CTraversabilityGridMap_00_insertOpts.extent=growing"});
}

TEST(OtherProcessor, GivesTheSameMapOfALaserDriveMatchedByIcp)
{
  NEEDS_ANOTHER_LIBRARY();
  expectSameArchive(ini("laser2d"), {"Maps_CTraversabilityGridMap_00_insertOpts.extent=growing"});
}
}  // namespace
