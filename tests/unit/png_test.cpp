// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/png.h>
#include <traverse/formats/safe_file.h>

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

bool same(traverse::layers::Colour a, traverse::layers::Colour b)
{
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST(Png, AnotherReaderFindsThePixels)
{
  TRAVERSE_NEEDS("/usr/bin/gdallocationinfo");
  Raster raster(3, 2, {10, 20, 30});
  raster.at(2, 1) = {255, 0, 128};
  raster.at(0, 0) = {1, 2, 3};
  const ScratchFolder folder;
  const auto path = folder.path() / "x.png";
  writeFile(path, png(raster));
  const auto pixel = [&](const std::string& at)
  { return outputOf("gdallocationinfo -valonly " + path.string() + " " + at); };
  EXPECT_EQ(pixel("0 0"), "1\n2\n3\n");
  EXPECT_EQ(pixel("1 0"), "10\n20\n30\n");
  EXPECT_EQ(pixel("2 1"), "255\n0\n128\n");
}

TEST(Png, SamePixelsGiveTheSameBytes)
{
  const Raster raster(40, 30, {1, 2, 3});
  EXPECT_EQ(png(raster), png(raster));
}

TEST(Png, APictureOfNoSizeIsRefused)
{
  EXPECT_THROW(png(Raster()), std::invalid_argument);
}

TEST(ClassPicture, IsNorthUpInTheLegendsExactColours)
{
  const auto set = drawnClasses({"14.", "2.3"});
  const Raster raster = classPicture(set, 1);
  ASSERT_EQ(raster.width, 3U);
  ASSERT_EQ(raster.height, 2U);
  EXPECT_TRUE(same(raster.at(0, 0), set.legend[1].colour));
  EXPECT_TRUE(same(raster.at(1, 0), set.legend[4].colour));
  EXPECT_TRUE(same(raster.at(2, 0), set.legend[0].colour));
  EXPECT_TRUE(same(raster.at(0, 1), set.legend[2].colour));
  EXPECT_TRUE(same(raster.at(2, 1), set.legend[3].colour));
}

TEST(ClassPicture, EnlargesSmallMapsByWholeNumbers)
{
  const Raster raster = classPicture(drawnClasses({"14.", "2.3"}), 10);
  EXPECT_EQ(raster.width, 12U) << "4 pixels a cell: the smallest whole number that reaches 10";
  EXPECT_EQ(raster.height, 8U);
}

TEST(ClassPicture, CodesWithoutALegendAreWhite)
{
  EXPECT_TRUE(same(classPicture(drawnClasses({"9"}), 1).at(0, 0), {255, 255, 255}));
}

TEST(ClassPicture, NeedsAClassLayer)
{
  auto set = drawnClasses({"1"});
  set.class_layer = "none";
  EXPECT_THROW(classPicture(set), std::invalid_argument);
}
}  // namespace
