// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// The octree of an MRPT map: asked for by ini, fed, saved, copied, cleared.
#include "support/map_by_ini.h"
#include "support/mrpt_logs.h"
#include "support/octree_points.h"
#include "support/scratch_folder.h"

#include <traverse/observations/convert.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using maps::CTraversabilityGridMap;
using mrpt::maps::CMultiMetricMap;
using mrpt::poses::CPose3D;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kOctomapOpts = kOneGrid + "[map_CTraversabilityGridMap_00_octomapOpts]\n";

size_t leaves(const CTraversabilityGridMap& map)
{
  const auto files = map.extraFiles();
  return files.empty() ? 0 : leavesOf(files[0].bytes).size();
}

TEST(OctreeMap, IsAskedForInTheIni)
{
  CMultiMetricMap map;
  build(map, kOctomapOpts + "resolution_m = 0.05\nmax_memory_mb = 50\n");
  map.insertObservation(*firstOf(kVelodyneLog));
  EXPECT_GT(leaves(*map.mapByClass<CTraversabilityGridMap>()), 10000U);
  CMultiMetricMap without;
  build(without, kOctomapOpts + "resolution_m = 0\n");
  without.insertObservation(*firstOf(kVelodyneLog));
  EXPECT_TRUE(without.mapByClass<CTraversabilityGridMap>()->extraFiles().empty());
}

TEST(OctreeMap, OptionsThatMakeNoSenseAreRefused)
{
  EXPECT_EQ(refusal(kOctomapOpts + "resolution_m = 0.1\n"), "accepted");
  EXPECT_THAT(
      refusal(kOctomapOpts + "resolution_m = 0.3\n"),
      AllOf(
          HasSubstr("_octomapOpts"), HasSubstr("resolution_m = '0.3'"), HasSubstr("cells of 0.2")));
  EXPECT_THAT(refusal(kOctomapOpts + "resolution_m = 0.0123\n"), HasSubstr("whole millimetres"));
  EXPECT_THAT(refusal(kOctomapOpts + "resolution_m = -1\n"), HasSubstr("resolution_m"));
  EXPECT_THAT(refusal(kOctomapOpts + "resolution = 0.1\n"), HasSubstr("'resolution_m'"));
}

TEST(OctreeMap, TheOctreeKeepsWhatTheWindowForgets)
{
  CTraversabilityGridMap map;
  map.insertionOptions.window_m = 20;
  map.octomapOptions.resolution_m = 0.1;
  for (const double x : {0.0, 100.0})
  {
    map.insertScan(
        scanOf({{1, 0, 0}, {1.05, 0.05, 0}, {30, 0, 0}}).view(),
        poses::PoseTrack::constant(observations::toIsometry(CPose3D(x, 0, 0, 0, 0, 0))));
  }
  EXPECT_EQ(map.state().occupied, 1U);
  EXPECT_EQ(leaves(map), 4U) << "two of them outside the window from the start";
}

TEST(OctreeMap, IsSavedBesideTheLayers)
{
  CTraversabilityGridMap map;
  map.octomapOptions.resolution_m = 0.1;
  map.insertObservation(*firstOf(kVelodyneLog));
  const ScratchFolder scratch;
  map.saveMetricMapRepresentationToFile((scratch / "m").string());
  EXPECT_EQ(readText(scratch / "m.bt"), map.extraFiles()[0].bytes);
  EXPECT_EQ(leavesOf(readText(scratch / "m.ot")).size(), leaves(map));
}

TEST(OctreeMap, GoesWithACopyAndIsGoneWithTheRest)
{
  CMultiMetricMap map;
  build(map, kOctomapOpts + "resolution_m = 0.1\n");
  map.insertObservation(*firstOf(kVelodyneLog));
  const CMultiMetricMap copy = map;  // through MRPT's serialisation
  const auto was = map.mapByClass<CTraversabilityGridMap>();
  const auto is = copy.mapByClass<CTraversabilityGridMap>();
  EXPECT_EQ(is->octomapOptions, was->octomapOptions);
  ASSERT_FALSE(is->extraFiles().empty());
  EXPECT_EQ(is->extraFiles()[0].bytes, was->extraFiles()[0].bytes);
  was->clear();
  EXPECT_TRUE(was->extraFiles().empty());
  EXPECT_FALSE(is->extraFiles().empty());
  is->setFromArchive(was->archive());
  EXPECT_TRUE(is->extraFiles().empty()) << "an archive has the cells only";
}

TEST(OctreeMap, DoesNotChangeTheArchive)
{
  CTraversabilityGridMap with;
  with.octomapOptions.resolution_m = 0.1;
  CTraversabilityGridMap without;
  for (CTraversabilityGridMap* map : {&with, &without})
  {
    map->insertObservation(*firstOf(kVelodyneLog));
  }
  EXPECT_EQ(with.archive(), without.archive());
}
}  // namespace
