// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// PGM + YAML as MRPT's converter reads them, and as ROS map_server's rule says.
#include <traverse/formats/occupancy_image.h>
#include <traverse/formats/safe_file.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/command.h>
#include <support/data.h>
#include <support/sample_layers.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using ::testing::HasSubstr;

mrpt::maps::COccupancyGridMap2D readByMrpt(const OccupancyImage& image)
{
  const ScratchFolder folder;
  writeFile(folder.path() / "map.pgm", image.pgm);
  writeFile(folder.path() / "map.yaml", image.yaml);
  const std::string text =
      outputOf("cd " + folder.path().string() + " && ros-map-yaml2mrpt -i map.yaml");
  mrpt::maps::COccupancyGridMap2D grid;
  mrpt::io::CFileGZInputStream file((folder.path() / "map.gridmap.gz").string());
  mrpt::serialization::archiveFrom(file) >> grid;
  return grid;
}

traverse::layers::LayerSet drawn()
{
  return drawnClasses(
      {"14.",  //
       "2.3"},
      {-1, 5}, 200);
}

TEST(OccupancyImage, MrptReadsObstacleDrivableAndUndefinedInTheirPlaces)
{
  TRAVERSE_NEEDS("/usr/bin/ros-map-yaml2mrpt");
  const auto grid = readByMrpt(occupancyOfClasses(drawn(), "map.pgm"));
  EXPECT_NEAR(grid.getResolution(), 0.2, 1e-6) << "float inside MRPT";
  EXPECT_NEAR(grid.getXMin(), -0.2, 1e-6);
  EXPECT_NEAR(grid.getYMin(), 1.0, 1e-6);
  EXPECT_GT(grid.getPos(-0.1F, 1.3F), 0.95F) << "flat is free";
  EXPECT_LT(grid.getPos(0.1F, 1.3F), 0.05F) << "obstacle is occupied";
  EXPECT_NEAR(grid.getPos(0.3F, 1.3F), 0.5F, 0.02F) << "undefined is unknown";
  EXPECT_GT(grid.getPos(-0.1F, 1.1F), 0.95F);
  EXPECT_NEAR(grid.getPos(0.1F, 1.1F), 0.5F, 0.02F);
  EXPECT_GT(grid.getPos(0.3F, 1.1F), 0.95F) << "large roughness can be driven";
}

/** map_server's rule for a pixel, as its documentation gives it. */
int mapServerValue(uint8_t pixel, bool scale, double occupied_thresh, double free_thresh)
{
  const double p = (255.0 - pixel) / 255.0;
  if (p > occupied_thresh)
  {
    return 100;
  }
  if (p < free_thresh)
  {
    return 0;
  }
  return scale ? static_cast<int>(99 * (p - free_thresh) / (occupied_thresh - free_thresh)) : -1;
}

std::vector<uint8_t> pixels(const OccupancyImage& image, size_t count)
{
  return {image.pgm.end() - static_cast<std::ptrdiff_t>(count), image.pgm.end()};
}

TEST(OccupancyImage, MapServerReadsObstacleDrivableAndUndefined)
{
  const OccupancyImage image = occupancyOfClasses(drawn(), "map.pgm");
  EXPECT_THAT(image.yaml, HasSubstr("mode: trinary"));
  EXPECT_THAT(image.yaml, HasSubstr("occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  std::vector<int> values;
  for (const uint8_t pixel : pixels(image, 6))
  {
    values.push_back(mapServerValue(pixel, false, 0.65, 0.196));
  }
  EXPECT_EQ(values, (std::vector<int>{0, 100, -1, 0, -1, 0}));
}

TEST(OccupancyImage, MapServerGivesTheIndexBack)
{
  auto set = drawn();
  set.layers.push_back({"index", "1", std::vector<uint8_t>{50, 0, 80, 20, 100, 0}});
  const OccupancyImage image = occupancyOfIndex(set, *set.find("index"), "index.pgm");
  EXPECT_THAT(image.yaml, HasSubstr("mode: scale"));
  EXPECT_THAT(image.yaml, HasSubstr("occupied_thresh: 0.99\nfree_thresh: 0"));
  const std::vector<int> expected = {20, 100, 50, 50, 50, 80};  // undefined cells: 50
  const std::vector<uint8_t> grey = pixels(image, 6);
  for (size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(mapServerValue(grey[i], true, 0.99, 0.0), expected[i], 1) << "8-bit pixels";
  }
}

TEST(OccupancyImage, MrptReadsTheIndexAsFreeness)
{
  TRAVERSE_NEEDS("/usr/bin/ros-map-yaml2mrpt");
  auto set = drawn();
  set.layers.push_back({"index", "1", std::vector<uint8_t>{50, 0, 80, 20, 100, 0}});
  const auto grid = readByMrpt(occupancyOfIndex(set, *set.find("index"), "map.pgm"));
  EXPECT_NEAR(grid.getPos(-0.1F, 1.3F), 0.8F, 0.02F) << "index 20; MRPT's cells have 8 bits";
  EXPECT_NEAR(grid.getPos(0.1F, 1.3F), 0.0F, 0.02F);
  EXPECT_NEAR(grid.getPos(0.3F, 1.3F), 0.5F, 0.02F) << "undefined";
  EXPECT_NEAR(grid.getPos(0.3F, 1.1F), 0.2F, 0.02F);
}

TEST(OccupancyImage, ItsNameCannotLeadElsewhere)
{
  EXPECT_THROW(occupancyOfClasses(drawn(), "../x.pgm"), std::invalid_argument);
  EXPECT_THROW(occupancyOfClasses(drawn(), "x.pgm\nmode: raw"), std::invalid_argument);
}
}  // namespace
