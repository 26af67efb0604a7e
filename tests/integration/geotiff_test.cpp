// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// GeoTIFFs as GDAL's own tools see them.
#include <traverse/formats/geotiff.h>
#include <traverse/formats/safe_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <support/command.h>
#include <support/data.h>
#include <support/sample_layers.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using ::testing::HasSubstr;
using ::testing::Not;
using traverse::geometry::CellIndex;
using traverse::layers::LayerSet;

/** A GeoTIFF on the disk, looked at from outside. */
class File
{
 public:
  File(const LayerSet& set, const std::string& layer) : path_(folder_.path() / "layer.tif")
  {
    writeFile(path_, geoTiff(set, *set.find(layer)));
  }

  std::string info() const { return outputOf("gdalinfo -stats " + path_.string()); }

  std::string valueAt(const std::string& x_y) const
  {
    std::string text = outputOf("gdallocationinfo -valonly -geoloc " + path_.string() + " " + x_y);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
    {
      text.pop_back();
    }
    return text;
  }

 private:
  ScratchFolder folder_;
  std::filesystem::path path_;
};

LayerSet asymmetric(CellIndex corner)
{
  return drawnClasses(
      {"14.",  //
       "2.3"},
      corner);
}

TEST(GeoTiff, NorthIsUpAndEveryCellIsInItsPlace)
{
  TRAVERSE_NEEDS("/usr/bin/gdalinfo");
  const File file(asymmetric({-1, 5}), "traversability_class");  // x from -0.2 m, y from 1 m
  EXPECT_EQ(file.valueAt("-0.1 1.3"), "1");
  EXPECT_EQ(file.valueAt("0.1 1.3"), "4");
  EXPECT_EQ(file.valueAt("-0.1 1.1"), "2");
  EXPECT_EQ(file.valueAt("0.3 1.1"), "3");
  EXPECT_THAT(file.info(), HasSubstr("Pixel Size = (0.200000000000000,-0.200000000000000)"));
  EXPECT_THAT(file.info(), HasSubstr("Origin = (-0.200000000000000,1.400000000000000)"));
}

TEST(GeoTiff, OriginsOfTenThousandKilometresAreExact)
{
  TRAVERSE_NEEDS("/usr/bin/gdalinfo");
  const File file(asymmetric({50'000'001, -50'000'001}), "traversability_class");
  EXPECT_THAT(
      file.info(), HasSubstr("Origin = (10000000.199999999254942,-9999999.800000000745058)"));
  EXPECT_EQ(file.valueAt("10000000.3 -9999999.9"), "1");
  EXPECT_EQ(file.valueAt("10000000.7 -10000000.1"), "3");
}

TEST(GeoTiff, IsInMetresOfALocalFrame)
{
  TRAVERSE_NEEDS("/usr/bin/gdalinfo");
  const std::string info = File(asymmetric({}), "traversability_class").info();
  EXPECT_THAT(info, HasSubstr("ENGCRS[\"map\""));
  EXPECT_THAT(info, HasSubstr("LENGTHUNIT[\"metre\",1"));
  EXPECT_THAT(info, Not(HasSubstr("PROJCRS")));
}

TEST(GeoTiff, TheClassLayerCarriesItsLegend)
{
  TRAVERSE_NEEDS("/usr/bin/gdalinfo");
  const std::string info = File(asymmetric({}), "traversability_class").info();
  EXPECT_THAT(info, HasSubstr("Type=Byte, ColorInterp=Palette"));
  EXPECT_THAT(info, HasSubstr("4: 250,220,40,255"));
  EXPECT_THAT(info, HasSubstr("CLASS_3=large roughness"));
  EXPECT_THAT(info, HasSubstr("NoData Value=0"));
  EXPECT_THAT(info, HasSubstr("Description = traversability_class"));
  EXPECT_THAT(info, HasSubstr("COMPRESSION=DEFLATE"));
}

TEST(GeoTiff, EveryTypeKeepsItsValues)
{
  TRAVERSE_NEEDS("/usr/bin/gdalinfo");
  LayerSet set = asymmetric({});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  set.layers.push_back({"slope_deg", "deg", std::vector<float>{1.5F, nan, -0.1F, 4, 5, 6}});
  set.layers.push_back({"height_mean", "m", std::vector<double>{1e7 + 0.001, 2, 3, 4, 5, 6}});
  set.layers.push_back({"point_count", "1", std::vector<uint32_t>{4294967295U, 2, 3, 4, 5, 6}});
  set.layers.push_back({"traversability_index", "1", std::vector<uint8_t>{0, 2, 3, 4, 100, 6}});

  const File slope(set, "slope_deg");
  EXPECT_THAT(slope.info(), HasSubstr("Type=Float32"));
  EXPECT_THAT(slope.info(), HasSubstr("NoData Value=nan"));
  EXPECT_THAT(slope.info(), HasSubstr("Unit Type: deg"));
  EXPECT_EQ(slope.valueAt("0.1 0.1"), "1.5");
  EXPECT_EQ(slope.valueAt("0.3 0.1"), "nan");
  EXPECT_EQ(slope.valueAt("0.5 0.1"), "-0.100000001490116");

  const File height(set, "height_mean");
  EXPECT_THAT(height.info(), HasSubstr("Type=Float64"));
  EXPECT_EQ(height.valueAt("0.1 0.1"), "10000000.001");

  const File count(set, "point_count");
  EXPECT_THAT(count.info(), HasSubstr("Type=UInt32"));
  EXPECT_THAT(count.info(), Not(HasSubstr("NoData")));
  EXPECT_EQ(count.valueAt("0.1 0.1"), "4294967295");

  const File index(set, "traversability_index");
  EXPECT_THAT(index.info(), Not(HasSubstr("NoData")));
  EXPECT_EQ(index.valueAt("0.3 0.3"), "100");
}

TEST(GeoTiff, SameLayerGivesTheSameBytes)
{
  const LayerSet set = asymmetric({});
  EXPECT_EQ(geoTiff(set, set.layers[0]), geoTiff(set, set.layers[0]));
}

TEST(GeoTiff, ALayerOfAnotherSizeIsRefused)
{
  LayerSet set = asymmetric({});
  set.extent.max.x += 1;
  EXPECT_THROW(geoTiff(set, set.layers[0]), std::invalid_argument);
  set.extent = {};
  EXPECT_THROW(geoTiff(set, set.layers[0]), std::invalid_argument);
}
}  // namespace
