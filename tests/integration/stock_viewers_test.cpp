// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// MRPT's own viewers with the plugin loaded by their -l flag, under an X server of their own.
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>
#include <traverse/plugin/register.h>

#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <support/data.h>
#include <support/mrpt_logs.h>
#include <unistd.h>

namespace
{
namespace fs = std::filesystem;
using namespace traverse;
using namespace traverse::testing;

class StockViewers : public ::testing::Test
{
 protected:
  void SetUp() override
  {
#ifdef TRAVERSE_SANITIZED
    GTEST_SKIP() << "SKIPPED: a stock program cannot host a sanitized library";
#endif
    if (std::system("command -v Xvfb xdotool >/dev/null") != 0)
    {
      GTEST_SKIP() << "SKIPPED: needs Xvfb and xdotool";
    }
    plugin::registerAllMaps();
    folder_ = fs::temp_directory_path() / ("traverse-viewers-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }

  void TearDown() override
  {
    fs::remove_all(folder_);
  }

  int drive(const std::string& script, const std::string& arguments) const
  {
    const std::string plugin = std::string(TRAVERSE_BINARY_DIR) + "/lib/libtraverse_maps.so";
    const std::string line = "cd '" + folder_.string() +
                             "' && bash '" TRAVERSE_SOURCE_DIR "/tests/integration/gui/" + script +
                             "' '" + plugin + "' " + arguments + " </dev/null";
    return std::system(line.c_str());
  }

  fs::path folder_;
};

bool isAlike(uint8_t a, uint8_t b)
{
  return std::abs(int{a} - int{b}) <= 1;  // the shader's rounding
}

/** Pixels of a colour in an XWD picture of 32 bits per pixel. */
size_t pixelsOf(const fs::path& xwd, layers::Colour colour)
{
  std::ifstream in(xwd, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto at = [&](size_t i) { return static_cast<uint8_t>(bytes[i]); };
  const size_t header = (at(2) << 8U) + at(3) + 256 * 12;  // and its colour map
  size_t count = 0;
  for (size_t i = header; i + 3 < bytes.size(); i += 4)
  {
    const bool is_one =
        isAlike(at(i), colour.b) && isAlike(at(i + 1), colour.g) && isAlike(at(i + 2), colour.r);
    count += is_one ? 1 : 0;
  }
  return count;
}

template <class Map>
class StockViewersOf : public StockViewers
{
};

using Maps = ::testing::Types<maps::CTraversabilityGridMap, maps::CWrappableMultiLidarGrid>;
TYPED_TEST_SUITE(StockViewersOf, Maps);

std::string nameOf(const mrpt::maps::CMetricMap& map)
{
  const std::string name = map.GetRuntimeClass()->className;
  return name.substr(name.rfind(':') + 1);
}

TYPED_TEST(StockViewersOf, RawLogViewerBuildsTheMapFromOdometry)
{
  fs::copy(mrptData("localization_demo.rawlog"), this->folder_);
  ASSERT_EQ(this->drive("rawlog_viewer.sh", "localization_demo.rawlog " + nameOf(TypeParam())), 0);
  mrpt::opengl::COpenGLScene scene;
  ASSERT_TRUE(scene.loadFromFile((this->folder_ / "map.3Dscene").string()));
  size_t triangles = 0;
  for (size_t i = 0; const auto surface = scene.getByClass<mrpt::opengl::CSetOfTriangles>(i); ++i)
  {
    triangles += surface->getTrianglesCount();
  }
  EXPECT_GT(triangles, 500U) << "the map's surface is in the scene that it saved";
}

TYPED_TEST(StockViewersOf, SceneViewerShowsTheLegendsColours)
{
  TypeParam map;
  map.vehicle.base_height_m = 2;  // the lidar's own frame is the log's only one
  for (const LoggedObservation& logged : readStockLog(mrptData("test_velodyne_VLP16.rawlog")))
  {
    map.insertObservation(*logged.observation);
  }
  mrpt::opengl::COpenGLScene scene;
  auto objects = mrpt::opengl::CSetOfObjects::Create();
  map.getVisualizationInto(*objects);
  scene.insert(objects);
  ASSERT_TRUE(scene.saveToFile((this->folder_ / "map.3Dscene").string()));
  ASSERT_EQ(this->drive("scene_viewer.sh", (this->folder_ / "map.3Dscene").string()), 0);
  size_t shown = 0;
  for (const layers::LegendEntry& entry : map.layerSet().legend)
  {
    shown += pixelsOf(this->folder_ / "screen.xwd", entry.colour) > 50 ? 1 : 0;
  }
  EXPECT_GE(shown, 3U) << "classes seen on the screen in their exact colours";
}
}  // namespace
