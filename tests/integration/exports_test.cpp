// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exports as others read them: GDAL's tools the GeoPackage, MRPT the PLY.
#include <traverse/formats/cloud_export.h>
#include <traverse/formats/geopackage.h>
#include <traverse/formats/safe_file.h>

#include <mrpt/maps/CSimplePointsMap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <support/command.h>
#include <support/data.h>
#include <support/every_type.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse::formats;
using namespace traverse::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using traverse::layers::LayerSet;
using Path = std::vector<std::array<double, 3>>;

/** A GeoPackage on the disk, as ogr2ogr and ogrinfo show it. */
class Package
{
 public:
  explicit Package(const LayerSet& set, const Path& path = {}) : file_(folder_.path() / "map.gpkg")
  {
    writeFile(file_, geoPackage(set, path));
  }

  std::string info(const std::string& options) const
  {
    return outputOf("ogrinfo " + options + " " + file_.string());
  }

  /** Rows of a query, cells of a row apart by ','. */
  std::vector<std::string> rows(const std::string& columns) const
  {
    std::istringstream all(outputOf(
        "ogr2ogr -f CSV /vsistdout/ " + file_.string() + " -sql 'SELECT " + columns +
        " FROM cells ORDER BY fid'"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(all, line);)
    {
      line.erase(std::remove(line.begin(), line.end(), '"'), line.end());
      lines.push_back(line);
    }
    lines.erase(lines.begin());
    return lines;
  }

 private:
  ScratchFolder folder_;
  std::filesystem::path file_;
};

TEST(GeoPackage, EveryKnownCellKeepsEveryValue)
{
  TRAVERSE_NEEDS("/usr/bin/ogr2ogr");
  const Package package(everyType({-1, -3}));
  EXPECT_THAT(
      package.rows("cell_x, cell_y, traversability_class, class_name, point_count"),
      ElementsAre(
          "-1,-3,2,small roughness,4294967295", "0,-3,0,undefined,0", "1,-3,3,large roughness,3",
          "-1,-2,1,flat,4", "0,-2,4,obstacle,5"))
      << "the sixth cell says nothing";
  EXPECT_THAT(package.rows("height_mean, last_seen_s")[1], ",10000000.001") << "NaN is NULL";
}

TEST(GeoPackage, NumbersAreTheLayersToTheLastBit)
{
  TRAVERSE_NEEDS("/usr/bin/ogr2ogr");
  const Package package(everyType({}));  // compared by SQLite, as CSV rounds to 15 digits
  EXPECT_THAT(
      package.rows("height_mean = -0.100000001490116119384765625, height_mean = 32500000, "
                   "last_seen_s = 1519637026.123456, last_seen_s = 4503599627370497.5"),
      ElementsAre("0,0,1,0", ",,0,0", "1,0,0,0", "0,0,,", "0,1,0,1"))
      << "a float is stored as the double that it is";
}

TEST(GeoPackage, CellsAreSquaresInTheirPlace)
{
  TRAVERSE_NEEDS("/usr/bin/ogrinfo");
  const Package package(everyType({-1, -3}));
  const std::string all = package.info("-al -where \"cell_x = 1\"");
  EXPECT_THAT(all, HasSubstr("POLYGON ((0.2 -0.6,0.4 -0.6,0.4 -0.4,0.2 -0.4,0.2 -0.6))"));
  const std::string summary = package.info("-so -al");
  EXPECT_THAT(summary, HasSubstr("Extent: (-0.200000, -0.600000) - (0.400000, -0.200000)"));
  EXPECT_THAT(summary, HasSubstr("ENGCRS[\"map\""));
  EXPECT_THAT(summary, HasSubstr("LENGTHUNIT[\"metre\",1]"));
  EXPECT_THAT(summary, Not(HasSubstr("ERROR")));
}

TEST(GeoPackage, TheTrajectoryIsALine)
{
  TRAVERSE_NEEDS("/usr/bin/ogrinfo");
  const Package package(everyType({}), {{-1.5, 2, 0.25}, {3, 4, 5}});
  EXPECT_THAT(package.info("-al"), HasSubstr("LINESTRING Z (-1.5 2.0 0.25,3 4 5)"));
  EXPECT_THAT(Package(everyType({}), {{1, 2, 3}}).info("-so -al"), Not(HasSubstr("trajectory")));
}

TEST(GeoPackage, IsSoundForSqlite)
{
  TRAVERSE_NEEDS("/usr/bin/ogrinfo");
  const Package package(everyType({}), {{-1.5, 2, 0.25}, {3, 4, 5}});
  EXPECT_THAT(
      package.info("-q -sql 'PRAGMA integrity_check'"), HasSubstr("integrity_check (String) = ok"));
}

TEST(GeoPackage, SameMapGivesTheSameBytes)
{
  const Path path = {{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(geoPackage(everyType({}), path), geoPackage(everyType({}), path));
}

TEST(GeoPackage, LayersOfHostileOrEqualNamesAreAllThere)
{
  TRAVERSE_NEEDS("/usr/bin/ogr2ogr");
  LayerSet set = drawnClasses({"1"});
  set.layers.push_back({"a\"; DROP TABLE cells; --", "", std::vector<float>{1.5F}});
  set.layers.push_back({"CELL_X", "", std::vector<float>{2.5F}});
  set.layers.push_back({"Cell_x", "", std::vector<float>{3.5F}});
  EXPECT_THAT(
      Package(set).rows("a___DROP_TABLE_cells____, CELL_X_2, Cell_x_3"),
      ElementsAre("1.5,2.5,3.5"));
}

TEST(GeoPackage, ALayerOfAnotherSizeIsRefused)
{
  LayerSet set = everyType({});
  set.extent.max.x += 1;
  EXPECT_THROW(geoPackage(set, {}), std::invalid_argument);
  EXPECT_THROW(plyCloud(set), std::invalid_argument);
  EXPECT_THROW(pcdCloud(set), std::invalid_argument);
}

/** A PLY as MRPT loads it: it takes the positions. */
mrpt::maps::CSimplePointsMap loaded(const LayerSet& set)
{
  const ScratchFolder folder;
  writeFile(folder / "map.ply", plyCloud(set));
  mrpt::maps::CSimplePointsMap points;
  EXPECT_TRUE(points.loadFromPlyFile(folder / "map.ply"));
  return points;
}

TEST(PlyCloud, MrptFindsThePoints)
{
  const auto points = loaded(everyType({-1, -3}));
  ASSERT_EQ(points.size(), 5U);
  const std::array<std::array<float, 3>, 5> expected = {
      {{-0.1F, -0.5F, 1.5F},
       {0.1F, -0.5F, 0},
       {0.3F, -0.5F, -0.1F},
       {-0.1F, -0.3F, 1e-20F},
       {0.1F, -0.3F, 3.25e7F}}};
  for (size_t i = 0; i < 5; ++i)
  {
    std::array<float, 3> p{};
    points.getPoint(i, p[0], p[1], p[2]);
    EXPECT_EQ(p, expected[i]) << i;
  }
}

TEST(PlyCloud, AMapOfOneCellIsOnePoint)
{
  EXPECT_EQ(loaded(drawnClasses({"1"})).size(), 1U);
}

TEST(PlyCloud, SaysItsPropertiesAndHasAllTheirBytes)
{
  const std::string ply = plyCloud(everyType({}));
  const size_t end = ply.find("end_header\n") + 11;
  EXPECT_THAT(
      ply.substr(0, end),
      HasSubstr("property uchar traversability_class\nproperty float height_mean\nproperty uint "
                "point_count\nproperty double last_seen_s\n"));
  EXPECT_EQ(ply.size() - end, 5U * (3 * 8 + 3 + 2 * 4 + 1 + 4 + 4 + 8));
}
}  // namespace
