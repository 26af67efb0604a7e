// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/config/strict.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>
#include <traverse/points/scan.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/serialization/CArchive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <support/map_by_ini.h>
#include <support/mrpt_logs.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using maps::CWrappableMultiLidarGrid;
using mrpt::maps::CMultiMetricMap;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kOneMap = "[map]\nCWrappableMultiLidarGrid_count = 1\n";
const std::string kOptions = "[map_CWrappableMultiLidarGrid_00_insertOpts]\n";

/** A wall ahead and the ground before it, from a label at a time. */
layers::UpdateStats insert(
    CWrappableMultiLidarGrid& map, const std::string& label, double time_s, double x_m = 0)
{
  points::ScanBuffer scan;
  scan.stamp = static_cast<poses::TimeNs>(time_s * 1e9);
  scan.sensor_label = label;
  scan.T_base_sensor.translation().z() = 1.8;
  for (int i = 0; i < 200; ++i)
  {
    const float y = -2 + 0.02F * static_cast<float>(i);
    for (const auto& [x, z] : {std::pair(8.0F, 0.5F), {8.0F, 1.0F}, {5.0F, 0.0F}})
    {
      scan.x.push_back(x + 0.001F * static_cast<float>(time_s));
      scan.y.push_back(y);
      scan.z.push_back(z);
    }
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = x_m;
  return map.insertScan(scan.view(), poses::PoseTrack::constant(pose));
}

TEST(MultiLidarMap, IsMadeByMrptsOwnIniMechanismUnderAllItsNames)
{
  for (const char* name :
       {"CWrappableMultiLidarGrid", "wrappableMultiLidarGrid",
        "traverse::maps::CWrappableMultiLidarGrid"})
  {
    CMultiMetricMap map;
    build(
        map, std::string("[map]\n") + name + "_count = 1\n[map_" + name +
                 "_00_insertOpts]\ncell_size_m = 0.1 // fine\nwindow_m = 40\ncells = paper\n[map_" +
                 name + "_00_likelihoodOpts]\nsigma_m = 0.5\n[map_" + name +
                 "_00_renderOpts]\nshow_points = false\n[map_" + name +
                 "_00_creationOpts]\nenableSaveAs3DObject = false\n[Vehicle]\nheight_m = 1.5\n");
    const auto grid = map.mapByClass<CWrappableMultiLidarGrid>();
    ASSERT_TRUE(grid) << name;
    EXPECT_EQ(grid->insertionOptions.cells, multi_lidar_grid::CellRule::paper);
    EXPECT_EQ(grid->likelihoodOptions.sigma_m, 0.5);
    EXPECT_FALSE(grid->renderOptions.show_points);
    EXPECT_EQ(grid->vehicle.height_m, 1.5);
    EXPECT_EQ(grid->state().lattice.cell_mm, 100);
    EXPECT_EQ(grid->state().cells.region().width(), 400);
    EXPECT_FALSE(grid->genericMapParams.enableSaveAs3DObject);
  }
}

TEST(MultiLidarMap, RefusesWhatItsSectionsShouldNotHave)
{
  EXPECT_EQ(refusal(kOneMap + kOptions + "cell_size_m = 0.3\n"), "accepted");
  EXPECT_THAT(
      refusal(kOneMap + kOptions + "timeouts_s = 0.2\n"),
      AllOf(HasSubstr("_insertOpts"), HasSubstr("timeouts_s"), HasSubstr("'timeout_s'")));
  EXPECT_THAT(refusal(kOneMap + kOptions + "strip = wide\n"), HasSubstr("default | paper | none"));
  EXPECT_THAT(
      refusal(kOneMap + kOptions + "sensor_labels = a b\nsensor_ranges_m = 20\n"),
      HasSubstr("one for each of sensor_labels"));
  EXPECT_THAT(
      refusal(kOneMap + kOptions + "sensor_labels = a b a\n"), HasSubstr("each label once"));
  EXPECT_THAT(
      refusal(kOneMap + kOptions + "window_m = 2000\ncell_size_m = 0.02\n"), HasSubstr("4096"));
  EXPECT_THAT(
      refusal(kOneMap + "[map_CWrappableMultiLidarGrid_00_octomapOpts]\nresolution_m = 1\n"),
      HasSubstr("_insertOpts"));
  EXPECT_THAT(
      refusal(kOneMap + "[Vehicle]\nheight_m = 0.2\n"), HasSubstr("the vehicle's height_m"));
}

TEST(MultiLidarMap, TakesChangedOptionsOnlyWhileItIsEmpty)
{
  CWrappableMultiLidarGrid map;
  map.insertionOptions.cell_size_m = 0.5;
  EXPECT_TRUE(insert(map, "roof", 1).inserted);
  EXPECT_EQ(map.state().lattice.cell_mm, 500);
  map.insertionOptions.cell_size_m = 0.2;
  EXPECT_THROW(insert(map, "roof", 1.1), std::invalid_argument);
  EXPECT_EQ(map.layerSet().lattice.cell_mm, 500) << "what it shows is what it was made with";
  map.clear();
  EXPECT_TRUE(insert(map, "roof", 1.2).inserted);
  EXPECT_EQ(map.state().lattice.cell_mm, 200);
}

TEST(MultiLidarMap, WarnsOfASensorThatFellSilent)
{
  CWrappableMultiLidarGrid map;
  insert(map, "roof", 0.0);
  insert(map, "left\n", 0.0);
  EXPECT_THAT(map.warnings(), IsEmpty());
  insert(map, "roof", 0.1);
  map.advance(poses::TimeNs{1'500'000'000});
  ASSERT_EQ(map.warnings().size(), 2U);
  EXPECT_THAT(map.warnings()[0], AllOf(HasSubstr("'roof' is stale"), HasSubstr("1.40 s old")));
  EXPECT_THAT(map.warnings()[1], HasSubstr("is stale"));
  EXPECT_THAT(map.warnings()[1], ::testing::Not(HasSubstr("\n"))) << "labels are untrusted text";
  insert(map, "roof", 9.0);
  ASSERT_EQ(map.warnings().size(), 1U);
  EXPECT_THAT(map.warnings()[0], HasSubstr("is dead"));
}

TEST(MultiLidarMap, WarnsOfLabelsOfWhichNoCloudCame)
{
  CWrappableMultiLidarGrid map;
  map.insertionOptions.sensor_labels = "roof rihgt";
  map.insertionOptions.clearing_labels = "ROOF";
  EXPECT_THAT(map.warnings(), IsEmpty()) << "before the first cloud";
  insert(map, "roof", 0.0);
  insert(map, "right", 0.0);
  ASSERT_EQ(map.warnings().size(), 2U);
  EXPECT_THAT(
      map.warnings()[0],
      AllOf(HasSubstr("sensor_labels names 'rihgt'"), HasSubstr("clouds came of 'roof', 'right'")));
  EXPECT_THAT(map.warnings()[1], HasSubstr("clearing_labels names 'ROOF'"));
}

TEST(MultiLidarMap, WarnsOfCloudsThatCameTooLate)
{
  CWrappableMultiLidarGrid map;
  insert(map, "roof", 10);
  EXPECT_FALSE(insert(map, "roof", 8).inserted);
  ASSERT_EQ(map.warnings().size(), 1U);
  EXPECT_THAT(map.warnings()[0], AllOf(HasSubstr("1 clouds"), HasSubstr("order_window_s = 1 s")));
}

TEST(MultiLidarMap, SaysThatPiecesDoNotMerge)
{
  CWrappableMultiLidarGrid map;
  insert(map, "roof", 1);
  EXPECT_THAT(map.mergeObstacle(), HasSubstr("order of the clouds"));
  EXPECT_THROW(map.mergeArchive(map.archive()), std::invalid_argument);
}

TEST(MultiLidarMap, IsAlsoAGridmapOfMrpt)
{
  CWrappableMultiLidarGrid map;
  insert(map, "roof", 1, 1000.1);
  const ScratchFolder folder;
  map.saveMetricMapRepresentationToFile((folder.path() / "m").string());
  mrpt::io::CFileGZInputStream file((folder.path() / "m.gridmap").string());
  mrpt::maps::COccupancyGridMap2D grid;
  mrpt::serialization::archiveFrom(file) >> grid;
  const layers::LayerSet set = map.layerSet();
  const auto& states = std::get<std::vector<uint8_t>>(set.find("occupancy_state")->data);
  ASSERT_EQ(grid.getSizeX(), static_cast<unsigned>(set.extent.width()));
  ASSERT_EQ(grid.getSizeY(), static_cast<unsigned>(set.extent.height()));
  size_t obstacles = 0;
  for (size_t i = 0; i < states.size(); ++i)
  {
    const geometry::CellIndex c{
        set.extent.min.x + static_cast<int32_t>(i % grid.getSizeX()),
        set.extent.min.y + static_cast<int32_t>(i / grid.getSizeX())};
    const float free = grid.getPos(
        static_cast<float>(set.lattice.centre_m(c.x)),
        static_cast<float>(set.lattice.centre_m(c.y)));
    const bool is_obstacle = states[i] == 2 || states[i] == 3;
    obstacles += static_cast<size_t>(is_obstacle);
    ASSERT_EQ(free < 0.3F, is_obstacle) << i;
    ASSERT_EQ(free > 0.7F, states[i] == 1 || states[i] == 4) << i;
  }
  EXPECT_GT(obstacles, 10U);
}

TEST(MultiLidarMap, SavesItsLayersAndAPictureForMapServer)
{
  CWrappableMultiLidarGrid map;
  insert(map, "roof", 1);
  const ScratchFolder folder;
  map.saveMetricMapRepresentationToFile((folder.path() / "m").string());
  for (const char* name :
       {"m.traverse", "m_occupancy_state.tif", "m_sensor_mask.tif", "m_safety_buffer.tif",
        "m_class.png", "m.pgm", "m.yaml"})
  {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / name)) << name;
  }
}

TEST(MultiLidarMap, ScansFitBestWhereTheyWereTaken)
{
  CWrappableMultiLidarGrid map;
  const auto scan = firstOf(kVelodyneLog);
  map.vehicle.base_height_m = 2;
  map.insertObservation(*scan);
  const double here = map.computeObservationLikelihood(*scan, mrpt::poses::CPose3D());
  for (const auto& [x, y] : {std::pair(1.0, 0.0), {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
  {
    EXPECT_GT(here, map.computeObservationLikelihood(*scan, mrpt::poses::CPose3D(x, y, 0)));
  }
}
}  // namespace
