// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// traverse-map --why: why a cell of an output folder is what it is.
#include "support/traverse_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using namespace traverse::testing;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Why : public ::testing::Test
{
 protected:
  static void SetUpTestSuite()
  {
    scratch = new ScratchFolder;
    const Finished ran = traverseMap(
        {ini("vlp16"), "--output", *scratch / "out", "--set", "Vehicle.base_height_m=0", "--set",
         "Maps.CTraversabilityGridMap_count=2", "--set", "traverse-map.scene=false", "--set",
         "traverse-map.picture_width_px=200"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }

  static void TearDownTestSuite()
  {
    delete scratch;
    scratch = nullptr;
  }

  static Finished why(const std::string& place, const std::string& folder = "out")
  {
    return traverseMap({"--why", place, *scratch / folder});
  }

  static inline ScratchFolder* scratch = nullptr;
};

TEST_F(Why, ExplainsTheCellOfEachMap)
{
  const Finished said = why("5.1,-2.3");
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_THAT(
      said.out, AllOf(
                    HasSubstr("map: map.traverse, traversability_grid\ncell: 20, -10\n"),
                    HasSubstr("\n\nmap: map_01.traverse, traversability_grid\ncell: 25, -12\n"),
                    HasSubstr("class: obstacle (4)\n"),
                    ContainsRegex("decided by: lowest point [0-9.]+ m above the ground, more "
                                  "than large_max_deviation_m = 0.25\n"),
                    HasSubstr("slab 0.5 m to 1 m: n = 5"), HasSubstr(" by Velodyne1_SCAN\n")));
  EXPECT_THAT(said.err, IsEmpty());
}

TEST_F(Why, TakesNegativeCoordinatesAndPlacesOffTheMap)
{
  EXPECT_THAT(why("-500,2").out, HasSubstr("cell: -2000, 8\n"));
  EXPECT_THAT(why("-500,2").out, HasSubstr("outside the window"));
}

TEST_F(Why, RefusesPlacesThatAreNone)
{
  for (const char* place : {"5", "5,", ",5", "5,x", "5,1,2", "nan,1", "1,inf", "1e9,0", "5 ,1"})
  {
    const Finished said = why(place);
    EXPECT_EQ(said.exit_code, 2) << place;
    EXPECT_THAT(said.err, HasSubstr("X,Y")) << place;
  }
}

TEST_F(Why, SaysWhyAFolderCannotBeRead)
{
  EXPECT_EQ(why("0,0", "nothing").exit_code, 4);
  std::filesystem::create_directory(*scratch / "empty");
  const Finished empty = why("0,0", "empty");
  EXPECT_EQ(empty.exit_code, 4);
  EXPECT_THAT(empty.err, HasSubstr("no map"));
  std::filesystem::create_directory(*scratch / "bad");
  const std::string good = readText(*scratch / "out" / "map.traverse");
  for (const std::string& bytes :
       {std::string(), std::string("nonsense"), good.substr(0, good.size() / 2)})
  {
    writeText(*scratch / "bad" / "map.traverse", bytes);
    const Finished damaged = why("0,0", "bad");
    EXPECT_EQ(damaged.exit_code, 4) << damaged.err;
    EXPECT_THAT(damaged.err, HasSubstr("map.traverse"));
  }
}
}  // namespace
