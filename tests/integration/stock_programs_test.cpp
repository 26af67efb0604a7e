// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's own programs, as Debian ships them, with libtraverse_maps.so loaded into them. They ignore
// a map that they do not know and end well all the same, so what counts is the files.
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <support/data.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using namespace traverse;
using namespace traverse::testing;

struct Finished
{
  int status = -1;
  std::string output;
};

/** `command` in a shell, with the plugin preloaded and nothing on its standard input. */
Finished run(const std::string& command, const fs::path& folder)
{
  const std::string plugin = std::string(TRAVERSE_BINARY_DIR) + "/lib/libtraverse_maps.so";
  const std::string line =
      "cd '" + folder.string() + "' && LD_PRELOAD='" + plugin + "' " + command + " </dev/null 2>&1";
  Finished result;
  FILE* pipe = ::popen(line.c_str(), "r");
  std::array<char, 4096> piece{};
  while (const size_t n = std::fread(piece.data(), 1, piece.size(), pipe))
  {
    result.output.append(piece.data(), n);
  }
  result.status = ::pclose(pipe);
  return result;
}

class StockPrograms : public ::testing::Test
{
 protected:
  void SetUp() override
  {
#ifdef TRAVERSE_SANITIZED
    GTEST_SKIP() << "SKIPPED: a stock program cannot host a sanitized library";
#endif
    folder_ = fs::temp_directory_path() / ("traverse-stock-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }

  void TearDown() override
  {
    fs::remove_all(folder_);
  }

  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder_ / name) << text;
  }

  /** The one file that a program wrote below the folder of a map's class with this ending. */
  fs::path onlyFile(const std::string& map_class, const std::string& ending) const
  {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
    {
      const std::string name = entry.path().filename();
      if (entry.path().extension() == ending && name.find(map_class) != std::string::npos)
      {
        found.push_back(entry.path());
      }
    }
    EXPECT_EQ(found.size(), 1U) << map_class;
    return found.size() == 1 ? found.front() : fs::path();
  }

  template <class Read>
  auto onlyArchive(const std::string& map_class, Read&& read) const
  {
    std::ifstream in(onlyFile(map_class, ".traverse"), std::ios::binary);
    return read(std::string((std::istreambuf_iterator<char>(in)), {}));
  }

  traversability_grid::Map traversability() const
  {
    return onlyArchive("CTraversabilityGridMap", traversability_grid::fromArchive);
  }

  multi_lidar_grid::Map states() const
  {
    return onlyArchive("CWrappableMultiLidarGrid", multi_lidar_grid::fromArchive);
  }

  fs::path folder_;
};

size_t cellsOf(const multi_lidar_grid::Map& map, layers::OccupancyState state)
{
  size_t count = 0;
  map.state.cells.forEach([&](geometry::CellIndex, const multi_lidar_grid::Cell& cell)
                          { count += cell.state == state ? 1 : 0; });
  return count;
}

TEST_F(StockPrograms, Observations2mapBuildsTheMap)
{
  write(
      "o2m.ini",
      "[map]\nCTraversabilityGridMap_count = 1\n"
      "[map_CTraversabilityGridMap_00_insertOpts]\nextent = growing\nindex_flat = 7\n");
  const Finished r = run(
      "observations2map o2m.ini " + mrptData("localization_demo.simplemap.gz") + " ./out_ -s map",
      folder_);
  EXPECT_EQ(r.status, 0) << r.output;
  const traversability_grid::Map map = traversability();
  EXPECT_EQ(map.params.index_flat, 7);
  // A robot drove 13 m through an office; its laser sees some tens of metres of walls, which are
  // one to a few cells wide.
  EXPECT_GT(map.state.occupied, 500U);
  EXPECT_LT(map.state.occupied, 20'000U);
}

/** Where pf-localization says the robot is at the end: "PDF estimation: (x,y,phi". */
std::array<double, 2> lastEstimate(const std::string& output)
{
  static constexpr std::string_view kWords = "PDF estimation: (";
  const size_t at = output.rfind(kWords);
  std::array<double, 2> place{NAN, NAN};
  if (at != std::string::npos)
  {
    std::istringstream in(output.substr(at + kWords.size()));
    char comma = 0;
    in >> place[0] >> comma >> place[1];
  }
  return place;
}

TEST_F(StockPrograms, PfLocalizationFindsTheRobotInTheMapOfSeveralLidars)
{
  write(
      "o2m.ini",
      "[map]\nCWrappableMultiLidarGrid_count = 1\n[Vehicle]\nheight_m = 1.5\n"
      "[map_CWrappableMultiLidarGrid_00_insertOpts]\ncell_size_m = 0.1\nwindow_m = 100\n");
  const Finished made = run(
      "observations2map o2m.ini " + mrptData("localization_demo.simplemap.gz") + " ./out_ -s map",
      folder_);
  ASSERT_EQ(made.status, 0) << made.output;
  const multi_lidar_grid::Map map = states();
  EXPECT_EQ(map.params.window_m, 100);
  // An office's corridor of 50 m and two rooms: outlines, and what is inside of them.
  EXPECT_GT(cellsOf(map, layers::OccupancyState::obstacle), 1000U);
  EXPECT_GT(cellsOf(map, layers::OccupancyState::free), 10'000U);
  write(
      "pf.ini",
      "[KLD_options]\nKLD_binSize_PHI_deg=10\nKLD_binSize_XY=0.10\nKLD_delta=0.02\n"
      "KLD_epsilon=0.02\nKLD_maxSampleSize=40000\nKLD_minSampleSize=150\n"
      "KLD_minSamplesPerBin=0\n[PF_options]\nPF_algorithm=0\nresamplingMethod=0\n"
      "adaptiveSampleSize=1\nBETA=0.5\nsampleSize=1\n[DummyOdometryParams]\n"
      "minStdXY=0.1\nminStdPHI=2\n[LocalizationExperiment]\nmap_file=" +
          onlyFile("CWrappableMultiLidarGrid", ".gridmap").string() +
          "\nrawlog_file=" + mrptData("localization_demo.rawlog") +
          "\nlogOutput_dir=PF\n3DSceneFrequency=100000\nexperimentRepetitions=1\n"
          "particles_count=20000\ninit_PDF_mode=0\ninit_PDF_min_x=1\ninit_PDF_max_x=7\n"
          "init_PDF_min_y=-13\ninit_PDF_max_y=-8\nSHOW_PROGRESS_3D_REAL_TIME=false\n"
          "[MetricMap]\noccupancyGrid_count=1\npointsMap_count=0\n"
          "likelihoodMapSelection=-1\n[MetricMap_occupancyGrid_00_creationOpts]\n"
          "resolution=0.1\n");
  const Finished localized = run("pf-localization pf.ini", folder_);
  EXPECT_EQ(localized.status, 0) << localized.output;
  // With MRPT's own grid of the same scans it ends at (15.92, -10.02) +- 0.02. Its dice are thrown
  // anew in each run: from 200 m2, or with 3000 particles, it is lost now and then in both grids.
  const auto [x, y] = lastEstimate(localized.output);
  EXPECT_NEAR(x, 15.91, 0.3) << "three cells";
  EXPECT_NEAR(y, -10.01, 0.3);
}

TEST_F(StockPrograms, IcpSlamBuildsTheMapsBesideItsOwn)
{
  write(
      "icp.ini",
      "[MappingApplication]\nrawlog_offset = 0\nlogOutput_dir = LOG\nLOG_FREQUENCY = "
      "1000\nSAVE_POSE_LOG = 0\n"
      "SAVE_3D_SCENE = 1\nCAMERA_3DSCENE_FOLLOWS_ROBOT = 0\nSHOW_PROGRESS_3D_REAL_TIME = 0\n"
      "localizationLinDistance = 0.3\nlocalizationAngDistance = 10\n"
      "insertionLinDistance = 1.0\ninsertionAngDistance = 30\nminICPgoodnessToAccept = 0.4\n"
      "matchAgainstTheGrid = 0\npointsMap_count = 1\nCTraversabilityGridMap_count = 1\n"
      "CWrappableMultiLidarGrid_count = 1\n"
      "[MappingApplication_pointsMap_00_insertOpts]\nminDistBetweenLaserPoints = 0.05\n"
      "[MappingApplication_CTraversabilityGridMap_00_insertOpts]\nextent = growing\n"
      "[ICP]\nmaxIterations = 80\nthresholdDist = 0.4\nthresholdAng_DEG = 3\n"
      "smallestThresholdDist = 0.05\ncorresponding_points_decimation = 5\n");
  const std::string log = mrptData("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");
  const Finished r = run("icp-slam icp.ini '" + log + "'", folder_);
  EXPECT_EQ(r.status, 0) << r.output.substr(0, 4000);
  const traversability_grid::Map map = traversability();
  EXPECT_GT(map.state.occupied, 500U);
  EXPECT_LT(map.state.occupied, 50'000U);
  EXPECT_GT(cellsOf(states(), layers::OccupancyState::obstacle), 500U);
}
}  // namespace
