// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/strict.h>
#include <traverse/formats/bytes.h>
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/observations/to_scan.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <support/data.h>
#include <support/map_by_ini.h>
#include <support/mrpt_logs.h>
#include <unistd.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using maps::CTraversabilityGridMap;
using mrpt::maps::CMultiMetricMap;
using mrpt::poses::CPose3D;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(TraversabilityMap, IsMadeByMrptsOwnIniMechanismUnderAllItsNames)
{
  for (const char* name :
       {"CTraversabilityGridMap", "traversabilityGridMap",
        "traverse::maps::CTraversabilityGridMap"})
  {
    CMultiMetricMap map;
    build(
        map, std::string("[map]\n") + name + "_count = 1\n[map_" + name +
                 "_00_insertOpts]\ncell_size_m = 0.1 // fine\nextent = growing\n[map_" + name +
                 "_00_likelihoodOpts]\nsigma_m = 0.3\n[map_" + name +
                 "_00_creationOpts]\nenableSaveAs3DObject = false\n[Vehicle]\nheight_m = 1.5\n");
    const auto grid = map.mapByClass<CTraversabilityGridMap>();
    ASSERT_TRUE(grid) << name;
    EXPECT_EQ(grid->insertionOptions.cell_size_m, 0.1);
    EXPECT_EQ(grid->insertionOptions.extent, traversability_grid::Extent::growing);
    EXPECT_EQ(grid->likelihoodOptions.sigma_m, 0.3);
    EXPECT_EQ(grid->vehicle.height_m, 1.5);
    EXPECT_EQ(grid->state().lattice.cell_mm, 100);
    EXPECT_FALSE(grid->genericMapParams.enableSaveAs3DObject);
  }
}

TEST(TraversabilityMap, RefusesWhatItsSectionsShouldNotHave)
{
  const std::string options = "[map_CTraversabilityGridMap_00_insertOpts]\n";
  EXPECT_EQ(refusal(kOneGrid + options + "cell_size_m = 0.2\n"), "accepted");
  EXPECT_THAT(
      refusal(kOneGrid + options + "cel_size_m = 0.2\n"),
      AllOf(HasSubstr("_insertOpts"), HasSubstr("cel_size_m"), HasSubstr("'cell_size_m'")));
  EXPECT_THAT(
      refusal(kOneGrid + options + "window_m = 1,5\n"),
      AllOf(HasSubstr("_insertOpts"), HasSubstr("window_m"), HasSubstr("1,5")));
  EXPECT_THAT(
      refusal(kOneGrid + options + "extent = round\n"), HasSubstr("rolling | fixed | growing"));
  EXPECT_THAT(
      refusal(kOneGrid + options + "small_max_slope_deg = 1\n"), HasSubstr("flat_max_slope_deg"));
  EXPECT_THAT(
      refusal(kOneGrid + "[map_CTraversabilityGridMap_00_insertOptions]\nmin_points = 4\n"),
      HasSubstr("_insertOpts"));
  EXPECT_THAT(
      refusal(
          kOneGrid + "[map_CTraversabilityGridMap_00_creationOpts]\nenableSaveAs3DObjects = 0\n"),
      HasSubstr("enableSaveAs3DObject"));
  EXPECT_THAT(refusal(kOneGrid + "[Vehicle]\nheigth_m = 2\n"), HasSubstr("height_m"));
}

TEST(TraversabilityMap, TakesEverySensorOfTheStockLogs)
{
  for (const std::string& log : {kVelodyneLog, kLaserLog, mrptData("tests_rgbd.rawlog")})
  {
    CTraversabilityGridMap map;
    map.sensors.depth_image_step = 4;
    EXPECT_TRUE(map.insertObservation(*firstOf(log), CPose3D(1, 2, 0, 0.3, 0, 0))) << log;
    EXPECT_FALSE(map.isEmpty());
    EXPECT_GT(map.state().occupied, 50U) << log;
  }
  CTraversabilityGridMap map;
  EXPECT_FALSE(map.insertObservation(mrpt::obs::CObservationComment()));
  EXPECT_TRUE(map.isEmpty());
}

TEST(TraversabilityMap, ClearReplacesTheWholeState)
{
  CTraversabilityGridMap map;
  map.insertionOptions.extent = traversability_grid::Extent::growing;
  const std::string empty = CTraversabilityGridMap(map).archive();
  map.insertObservation(*firstOf(kVelodyneLog));
  const std::string full = map.archive();
  map.clear();
  EXPECT_TRUE(map.isEmpty());
  EXPECT_EQ(map.archive(), empty);
  map.insertObservation(*firstOf(kVelodyneLog));
  EXPECT_EQ(map.archive(), full);
}

TEST(TraversabilityMap, SurvivesCopyAndSerialisationOfAMultiMap)
{
  CMultiMetricMap map;
  build(
      map,
      "[map]\nCTraversabilityGridMap_count = 2\npointsMap_count = 1\n"
      "[map_CTraversabilityGridMap_01_insertOpts]\ncell_size_m = 0.5\n"
      "[map_CTraversabilityGridMap_01_likelihoodOpts]\nworst = 7\n");
  const auto scan = firstOf(kVelodyneLog);
  EXPECT_TRUE(map.insertObservation(*scan));
  const CMultiMetricMap copy = map;
  mrpt::io::CMemoryStream stream;
  auto archive = mrpt::serialization::archiveFrom(stream);
  archive << map;
  stream.Seek(0);
  CMultiMetricMap read;
  archive >> read;
  for (const CMultiMetricMap* other : {&copy, static_cast<const CMultiMetricMap*>(&read)})
  {
    for (size_t i = 0; i < 2; ++i)
    {
      const auto was = map.mapByClass<CTraversabilityGridMap>(i);
      const auto is = other->mapByClass<CTraversabilityGridMap>(i);
      ASSERT_TRUE(is);
      EXPECT_EQ(is->archive(), was->archive());
      EXPECT_EQ(is->likelihoodOptions, was->likelihoodOptions);
    }
  }
  map.clear();
  EXPECT_FALSE(copy.mapByClass<CTraversabilityGridMap>()->isEmpty()) << "a copy shares nothing";
}

TEST(TraversabilityMap, MatchingOfAMultiMapDoesNotThrow)
{
  CMultiMetricMap map;
  build(map, "[map]\nCTraversabilityGridMap_count = 1\npointsMap_count = 1\n");
  map.insertObservation(*firstOf(kVelodyneLog));
  const auto points = map.mapByClass<mrpt::maps::CSimplePointsMap>();
  EXPECT_NO_THROW(map.compute3DMatchingRatio(points.get(), CPose3D(), {}));
  const auto grid = map.mapByClass<CTraversabilityGridMap>();
  EXPECT_EQ(grid->compute3DMatchingRatio(points.get(), CPose3D(), {}), 0);
}

TEST(TraversabilityMap, ATruncatedStreamIsRefused)
{
  CTraversabilityGridMap map;
  map.insertObservation(*firstOf(kVelodyneLog));
  mrpt::io::CMemoryStream whole;
  mrpt::serialization::archiveFrom(whole) << map;
  const auto size = static_cast<size_t>(whole.getTotalBytesCount());
  for (const size_t length : {size_t{60}, size_t{200}, size / 2, size - 1})
  {
    mrpt::io::CMemoryStream cut;
    cut.Write(whole.getRawBufferData(), length);
    cut.Seek(0);
    auto archive = mrpt::serialization::archiveFrom(cut);
    CTraversabilityGridMap read;
    EXPECT_ANY_THROW(archive >> read) << length;
  }
}

TEST(TraversabilityMap, DrawsItselfInTheLegendsColoursUnlit)
{
  CTraversabilityGridMap map;
  map.insertObservation(*firstOf(kVelodyneLog));
  mrpt::opengl::CSetOfObjects scene;
  map.getVisualizationInto(scene);
  const auto surface = scene.getByClass<mrpt::opengl::CSetOfTriangles>();
  ASSERT_TRUE(surface);
  EXPECT_FALSE(surface->isLightEnabled());
  EXPECT_EQ(surface->getTrianglesCount(), 2 * map.state().occupied);
  std::set<int> colours;
  for (size_t i = 0; i < surface->getTrianglesCount(); ++i)
  {
    mrpt::opengl::TTriangle t;
    surface->getTriangle(i, t);
    colours.insert((t.r(0) << 16) + (t.g(0) << 8) + t.b(0));
  }
  std::set<int> legend;
  for (const layers::LegendEntry& e : map.layerSet().legend)
  {
    legend.insert((e.colour.r << 16) + (e.colour.g << 8) + e.colour.b);
  }
  EXPECT_GE(colours.size(), 3U);
  EXPECT_TRUE(std::includes(legend.begin(), legend.end(), colours.begin(), colours.end()));

  map.genericMapParams.enableSaveAs3DObject = false;
  mrpt::opengl::CSetOfObjects none;
  map.getVisualizationInto(none);
  EXPECT_TRUE(none.empty());
}

TEST(TraversabilityMap, SavesAnArchiveThatReadsBackAndItsLayers)
{
  CTraversabilityGridMap map;
  map.insertObservation(*firstOf(kVelodyneLog));
  const auto folder =
      std::filesystem::temp_directory_path() / ("traverse-save-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  map.saveMetricMapRepresentationToFile((folder / "m").string());
  for (const char* name : {"m_traversability_class.tif", "m_height_mean.tif", "m_class.png"})
  {
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  }
  std::ifstream in(folder / "m.traverse", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  CTraversabilityGridMap read;
  read.setFromArchive(bytes);
  EXPECT_EQ(read.archive(), map.archive());
  EXPECT_THROW(read.setFromArchive("nonsense"), formats::FormatError);
  EXPECT_EQ(read.archive(), map.archive());
  std::filesystem::remove_all(folder);
}
}  // namespace
