// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's own programs, as Debian ships them, with libtraverse_maps.so loaded into them. They ignore
// a map that they do not know and end well all the same, so what counts is the files.
#include <traverse/traversability_grid/traversability_grid.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
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

  /** The one archive that a program wrote below the folder. */
  traversability_grid::Map onlyArchive() const
  {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
    {
      if (entry.path().extension() == ".traverse")
      {
        found.push_back(entry.path());
      }
    }
    EXPECT_EQ(found.size(), 1U);
    if (found.size() != 1)
    {
      return {};
    }
    std::ifstream in(found.front(), std::ios::binary);
    return traversability_grid::fromArchive(std::string((std::istreambuf_iterator<char>(in)), {}));
  }

  fs::path folder_;
};

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
  const traversability_grid::Map map = onlyArchive();
  EXPECT_EQ(map.params.index_flat, 7);
  // A robot drove 13 m through an office; its laser sees some tens of metres of walls, which are
  // one to a few cells wide.
  EXPECT_GT(map.state.occupied, 500U);
  EXPECT_LT(map.state.occupied, 20'000U);
}

TEST_F(StockPrograms, IcpSlamBuildsTheMapBesideItsOwn)
{
  write(
      "icp.ini",
      "[MappingApplication]\nrawlog_offset = 0\nlogOutput_dir = LOG\nLOG_FREQUENCY = "
      "1000\nSAVE_POSE_LOG = 0\n"
      "SAVE_3D_SCENE = 1\nCAMERA_3DSCENE_FOLLOWS_ROBOT = 0\nSHOW_PROGRESS_3D_REAL_TIME = 0\n"
      "localizationLinDistance = 0.3\nlocalizationAngDistance = 10\n"
      "insertionLinDistance = 1.0\ninsertionAngDistance = 30\nminICPgoodnessToAccept = 0.4\n"
      "matchAgainstTheGrid = 0\npointsMap_count = 1\nCTraversabilityGridMap_count = 1\n"
      "[MappingApplication_pointsMap_00_insertOpts]\nminDistBetweenLaserPoints = 0.05\n"
      "[MappingApplication_CTraversabilityGridMap_00_insertOpts]\nextent = growing\n"
      "[ICP]\nmaxIterations = 80\nthresholdDist = 0.4\nthresholdAng_DEG = 3\n"
      "smallestThresholdDist = 0.05\ncorresponding_points_decimation = 5\n");
  const std::string log = mrptData("2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog");
  const Finished r = run("icp-slam icp.ini '" + log + "'", folder_);
  EXPECT_EQ(r.status, 0) << r.output.substr(0, 4000);
  const traversability_grid::Map map = onlyArchive();
  EXPECT_GT(map.state.occupied, 500U);
  EXPECT_LT(map.state.occupied, 50'000U);
}
}  // namespace
