// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/geotiff.h>
#include <traverse/formats/geotiff_read.h>
#include <traverse/formats/safe_file.h>
#include <traverse/simulation/truth_files.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <support/command.h>
#include <support/data.h>
#include <support/sample_layers.h>
#include <support/scratch_folder.h>
#include <support/truth_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::formats;
using namespace traverse::testing;
using layers::LayerSet;

LayerSet sample()
{
  LayerSet set = drawnClasses({"14.", "2.3"}, {-1, 5});
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  set.layers.push_back({"height", "m", std::vector<float>{1.5F, kNan, -2, 3, 4, 5}});
  set.layers.push_back({"count", "1", std::vector<uint32_t>{1, 2, 3, 4, 5, 4000000000U}});
  set.layers.push_back({"seen", "s", std::vector<double>{1e9 + 0.25, 2, 3, 4, 5, 6}});
  return set;
}

TEST(GeoTiffRead, GivesBackEveryLayer)
{
  const LayerSet set = sample();
  for (const layers::Layer& layer : set.layers)
  {
    const std::string bytes = geoTiff(set, layer);
    const LayerSet back = parseGeoTiff(bytes, "x");
    EXPECT_EQ(back.lattice, set.lattice);
    EXPECT_EQ(back.extent, set.extent);
    ASSERT_EQ(back.layers.size(), 1U);
    EXPECT_EQ(back.layers[0].name, layer.name);
    EXPECT_EQ(back.layers[0].unit, layer.unit);
    EXPECT_EQ(geoTiff(back, back.layers[0]), bytes) << layer.name;
  }
}

TEST(GeoTiffRead, GivesBackTheLegend)
{
  const LayerSet set = sample();
  const LayerSet back = parseGeoTiff(geoTiff(set, set.layers[0]), "x");
  EXPECT_EQ(back.class_layer, set.class_layer);
  ASSERT_EQ(back.legend.size(), set.legend.size());
  EXPECT_EQ(back.legend[4].name, "obstacle");
  EXPECT_EQ(back.legend[4].colour.g, set.legend[4].colour.g);
  EXPECT_TRUE(parseGeoTiff(geoTiff(set, set.layers[1]), "x").legend.empty());
}

TEST(GeoTiffRead, JoinsFilesOfTheSameCells)
{
  const ScratchFolder folder;
  const LayerSet set = sample();
  std::vector<std::filesystem::path> files;
  for (const layers::Layer& layer : set.layers)
  {
    files.push_back(folder.path() / (layer.name + ".tif"));
    writeFile(files.back(), geoTiff(set, layer));
  }
  EXPECT_EQ(readGeoTiffs(files).layers.size(), 4U);
  files.push_back(files.front());
  EXPECT_THROW(readGeoTiffs(files), FormatError);  // twice
  files.back() = folder.path() / "other.tif";
  LayerSet other = drawnClasses({"14.", "2.3"}, {0, 5});
  other.layers[0].name = "other";
  writeFile(files.back(), geoTiff(other, other.layers[0]));
  EXPECT_THROW(readGeoTiffs(files), FormatError);  // elsewhere
  EXPECT_THROW(readGeoTiffs({folder.path() / "none.tif"}), FormatError);
}

TEST(GeoTiffRead, DamageIsRefusedOrHarmless)
{
  const LayerSet set = sample();
  const std::string good = geoTiff(set, set.layers[1]);
  size_t refused = 0;
  for (size_t i = 0; i < good.size(); ++i)
  {
    for (const char mask : {'\x01', '\x80', '\xFF'})
    {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ mask);
      try
      {
        const LayerSet back = parseGeoTiff(bad, "x");
        EXPECT_LE(back.size(), 25'000'000U);
      }
      catch (const FormatError&)
      {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, good.size() / 10);  // most of a small file is header
  for (size_t length = 0; length < good.size(); length += 7)
  {
    EXPECT_THROW(parseGeoTiff(good.substr(0, length), "x"), FormatError) << length;
  }
}

TEST(GeoTiffRead, OtherRastersAreRefused)
{
  TRAVERSE_NEEDS("/usr/bin/gdal_translate");
  const ScratchFolder folder;
  const LayerSet set = sample();
  writeFile(folder.path() / "a.tif", geoTiff(set, set.layers[1]));
  const auto refused = [&](const std::string& options)
  {
    const std::string out = (folder.path() / "b.tif").string();
    outputOf("gdal_translate -q " + options + " " + (folder.path() / "a.tif").string() + " " + out);
    EXPECT_THROW(readGeoTiffs({out}), FormatError) << options;
    std::filesystem::remove(out);
  };
  refused("-b 1 -b 1");
  refused("-ot Int16");
  refused("-of PNG -ot Byte");
  refused("-a_ullr 0 1 1 0");        // oblong
  refused("-a_ullr 0.1 0.4 0.7 0");  // off the lattice
  refused("-a_ullr 0 0.0003 0.00045 0");
}

TEST(TruthFiles, ReadBackAsTheTruth)
{
  simulation::Scene scene = levelScene();
  scene.objects.push_back(boxObject({{1, 1, 0}, {2, 2, 1}}, simulation::Label::vehicle));
  const auto files = simulation::truthFiles(scene, {});
  std::set<std::string> names;
  for (const simulation::TruthFile& file : files)
  {
    names.insert(file.name);
    if (file.name == "truth_class.tif")
    {
      const LayerSet back = parseGeoTiff(file.bytes, file.name);
      EXPECT_EQ(
          back.layers[0].data,
          simulation::cellTruth(scene, {}, {}, 0, {0, 0}).find("truth_class")->data);
      EXPECT_EQ(back.legend.size(), 5U);
    }
  }
  for (const char* name :
       {"truth_class.tif", "truth_state.tif", "truth_ground_height.tif", "truth_swept.tif",
        "footprints.geojson"})
  {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}
}  // namespace
