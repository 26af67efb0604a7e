// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/gzip.h>
#include <traverse/formats/safe_file.h>
#include <traverse/simulation/build.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <support/data.h>
#include <support/scene_words.h>
#include <support/scratch_folder.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

constexpr double kExact_m = 1e-12;  // sums and products of a few doubles

TEST(Terrain, IsFlatGroundWhereNothingIsSaid)
{
  const GroundAt ground = buildTerrain(sceneWith({}))->at(3, 4);
  EXPECT_EQ(ground.height_m, 0);
  EXPECT_EQ(ground.label, Label::ground);
  EXPECT_EQ(ground.material, Material::soil);
}

TEST(Terrain, KerbRaisesThePavementOverAnEdge)
{
  TerrainParams kerb = terrainOf(TerrainKind::kerb);
  kerb.x_m = -10;
  kerb.width_m = 2;
  kerb.height_m = 0.12;
  kerb.edge_m = 0.02;
  const auto terrain = buildTerrain(sceneWith({kerb}));
  EXPECT_EQ(terrain->at(0, 1.001).height_m, 0);
  EXPECT_NEAR(terrain->at(0, 0.99).height_m, 0.06, kExact_m);  // half way up
  EXPECT_NEAR(terrain->at(0, 0.9).height_m, 0.12, kExact_m);
  EXPECT_NEAR(terrain->at(0, 0.9).base_m, 0.12, kExact_m);  // one drives on it
  EXPECT_EQ(terrain->at(0, 0.9).label, Label::pavement);
}

TEST(Terrain, BankStandsOnTheBase)
{
  TerrainParams bank = terrainOf(TerrainKind::bank);
  bank.x_m = -10;
  bank.width_m = 1;
  bank.height_m = 0.2;
  const auto terrain = buildTerrain(sceneWith({bank}));
  for (const double x : {-8.0, -3.3, 0.0, 4.7})
  {
    const GroundAt top = terrain->at(x, 0.1);
    EXPECT_EQ(top.base_m, 0);
    EXPECT_GE(top.height_m, 0.15);  // its top is uneven by a quarter
    EXPECT_LE(top.height_m, 0.2);
    EXPECT_EQ(top.label, Label::bank);
    EXPECT_EQ(top.material, Material::snow);
  }
  EXPECT_EQ(terrain->at(0, 0.51).height_m, 0);
}

TEST(Terrain, RutsAreTwoGrooves)
{
  TerrainParams ruts = terrainOf(TerrainKind::ruts);
  ruts.x_m = -10;
  ruts.width_m = 1.5;
  ruts.groove_m = 0.3;
  ruts.height_m = 0.07;
  const auto terrain = buildTerrain(sceneWith({ruts}));
  for (const double y : {-0.75, 0.75, 0.65})
  {
    EXPECT_NEAR(terrain->at(0, y).height_m, -0.07, kExact_m);
    EXPECT_EQ(terrain->at(0, y).label, Label::rut);
    EXPECT_EQ(terrain->at(0, y).base_m, 0);
  }
  EXPECT_EQ(terrain->at(0, 0).height_m, 0);
  EXPECT_EQ(terrain->at(0, 0.91).height_m, 0);
  EXPECT_EQ(terrain->at(-10.1, 0.75).height_m, 0);
}

TEST(Terrain, DitchesAndHolesSayHowDeepTheyAre)
{
  TerrainParams ditch = terrainOf(TerrainKind::ditch);
  ditch.xs_m = {-10, 0, 10};
  ditch.ys_m = {0, 0, 5};
  ditch.width_m = 1;
  ditch.height_m = 0.6;
  TerrainParams hole = terrainOf(TerrainKind::hole);
  hole.x_m = -5;
  hole.y_m = -5;
  hole.width_m = 0.8;
  hole.height_m = 0.4;
  const auto terrain = buildTerrain(sceneWith({ditch, hole}));
  for (const double x : {-6.0, 6.0})
  {
    const GroundAt bottom = terrain->at(x, x < 0 ? 0 : 3);
    EXPECT_NEAR(bottom.ditch_m, 0.6, kExact_m);
    EXPECT_NEAR(bottom.height_m, -0.6, kExact_m);
    EXPECT_EQ(bottom.base_m, 0);
    EXPECT_EQ(bottom.label, Label::ditch);
  }
  EXPECT_NEAR(terrain->at(-5.2, -5.1).ditch_m, 0.4, kExact_m);
  EXPECT_EQ(terrain->at(-5.41, -5).ditch_m, 0);
}

TEST(Terrain, RampLeadsUpToAPlain)
{
  TerrainParams ramp = terrainOf(TerrainKind::ramp);
  ramp.length_m = 5;
  ramp.height_m = 1;
  const auto terrain = buildTerrain(sceneWith({ramp}));
  EXPECT_EQ(terrain->at(-1, 7).height_m, 0);
  EXPECT_NEAR(terrain->at(2.5, 7).height_m, 0.5, kExact_m);
  EXPECT_NEAR(terrain->at(15, -7).base_m, 1, kExact_m);
}

TEST(Terrain, RoadTakesTheRoughnessOfTheFieldAway)
{
  TerrainParams rough = terrainOf(TerrainKind::roughness);
  rough.height_m = 0.05;
  TerrainParams road = terrainOf(TerrainKind::road);
  road.x_m = -10;
  road.width_m = 4;
  const auto terrain = buildTerrain(sceneWith({rough, road}));
  EXPECT_NE(terrain->at(0.3, 5.2).height_m, 0);
  EXPECT_EQ(terrain->at(0.3, 5.2).base_m, 0);
  EXPECT_EQ(terrain->at(0.3, 1.2).height_m, 0);
  EXPECT_EQ(terrain->at(0.3, 1.2).label, Label::road);
}

TEST(Terrain, TellsWhereItIsSharp)
{
  TerrainParams kerb = terrainOf(TerrainKind::kerb);
  kerb.x_m = -15;
  kerb.length_m = 30;
  kerb.width_m = 6;
  const auto terrain = buildTerrain(sceneWith({terrainOf(TerrainKind::hills), kerb}));
  EXPECT_TRUE(terrain->isSharpIn({0, 2.8, 0.5, 3.3}));
  EXPECT_FALSE(terrain->isSharpIn({0, 4, 1, 5}));
  EXPECT_FALSE(terrain->isSharpIn({0, -0.5, 1, 0.5}));  // the flat middle of the pavement
}

/** Wherever neighbouring heights of random scenes jump, a fine mesh is asked for. */
TEST(Terrain, NeverHidesASharpPlace)
{
  for (uint64_t seed = 1; seed <= 5; ++seed)
  {
    const auto terrain = buildTerrain(randomScene(seed));
    for (int i = 0; i < 40000; ++i)
    {
      const int row = i / 200;
      const double x = -29 + (i % 200) * 0.29;
      const double y = -29 + row * 0.29;
      const double jump = std::abs(terrain->at(x, y).height_m - terrain->at(x + 0.04, y).height_m);
      if (jump > 0.02)
      {
        EXPECT_TRUE(terrain->isSharpIn({x, y, x + 0.04, y + 0.04}))
            << seed << ": " << x << " " << y;
      }
    }
  }
}

/** The bins only leave out what does not reach a place: a scene of another size has other bins. */
TEST(Terrain, IsTheSameWhateverTheAreaIs)
{
  SceneParams scene = randomScene(3);
  const auto terrain = buildTerrain(scene);
  scene.extent.min_x_m = -31.7;
  scene.extent.max_y_m = 47.3;
  const auto other = buildTerrain(scene);
  for (int i = 0; i < 5000; ++i)
  {
    const int row = i / 100;
    const double x = -35 + (i % 100) * 0.71;
    const double y = -35 + row * 1.37;
    EXPECT_EQ(terrain->at(x, y).height_m, other->at(x, y).height_m) << x << " " << y;
  }
}

TEST(Terrain, RefusesWithSectionAndKey)
{
  TerrainParams ditch = terrainOf(TerrainKind::ditch);
  ditch.xs_m = {1, 2, 3};
  try
  {
    buildTerrain(sceneWith({terrainOf(TerrainKind::hills), ditch}));
    FAIL() << "was accepted";
  }
  catch (const std::runtime_error& e)
  {
    EXPECT_NE(std::string(e.what()).find("[Terrain_01] xs_m"), std::string::npos) << e.what();
  }
}

TEST(Raster, HasTheSurveyedHeightsAtItsNodes)
{
  const auto folder = sharedData("argoverse2-2xVLP32C");
  TRAVERSE_NEEDS(folder / "ground_height_785x880_float32.raw.gz");
  TerrainParams raster = terrainOf(TerrainKind::raster);
  raster.file = "ground_height_785x880_float32.raw.gz";
  raster.transform_file = "7fab2350-7eaf-3b7e-a39d-6937a4c1bede___img_Sim2_city.json";
  // node (column 334, row 450): city = (column, row) / s - t
  const auto city = [](double node, double t) { return node * 0.3 - t; };
  raster.origin_x_m = city(334, -5072.400390625);
  raster.origin_y_m = city(450, -2283.900390625);
  SceneParams scene = sceneWith({raster});
  scene.folder = folder;
  const auto terrain = buildTerrain(scene);
  EXPECT_NEAR(terrain->at(0, 0).height_m, 0, 1e-9);
  const double a = terrain->at(0.3, 0).height_m;
  const double b = terrain->at(0.6, 0).height_m;
  EXPECT_NEAR(terrain->at(0.45, 0).height_m, (a + b) / 2, 1e-6);  // bilinear between nodes
  // the vehicle that surveyed it drove from (5172.67, 2419.10, 66.93) to (5202.59, 2399.85, 68.15)
  EXPECT_NEAR(terrain->at(30, -19.2).height_m, 68.15 - 66.93, 0.1);
}

TEST(Raster, IsMadeOfGroundPoints)
{
  const auto folder = sharedData("terrain-isprs");
  TRAVERSE_NEEDS(folder / "samp11-utm-ground.pcd");
  TerrainParams raster = terrainOf(TerrainKind::raster);
  raster.file = "samp11-utm-ground.pcd";
  raster.origin_x_m = 512760;
  raster.origin_y_m = 5403700;
  SceneParams scene = sceneWith({raster});
  scene.folder = folder;
  const auto terrain = buildTerrain(scene);
  EXPECT_EQ(terrain->at(0, 0).height_m, 0);
  EXPECT_LT(std::abs(terrain->at(10, 0).height_m), 20);
}

TEST(Raster, RefusesAFileThatDoesNotFitItsName)
{
  TerrainParams raster = terrainOf(TerrainKind::raster);
  for (const char* name :
       {"", "x_float32.raw.gz", "x_1x5_float32.raw.gz", "x_99999999x99999999_float32.raw.gz",
        "missing_3x3_float32.raw.gz", "missing.pcd"})
  {
    raster.file = name;
    EXPECT_THROW(buildTerrain(sceneWith({raster})), std::runtime_error) << name;
  }
}

TEST(Raster, RefusesHeightsThatNoGroundHas)
{
  const ScratchFolder folder;
  const std::array<float, 4> heights = {0, 1, 1e38F, 2};
  std::string bytes(sizeof heights, '\0');
  std::memcpy(bytes.data(), heights.data(), bytes.size());
  formats::writeFile(folder / "x_2x2_float32.raw.gz", formats::gzip(bytes));
  formats::writeFile(folder / "x.json", R"({"R": [1, 0, 0, 1], "t": [0, 0], "s": 1})");
  formats::writeFile(folder / "x.csv", "x,y,z\n0,0,0\n1,0,1\n0,1,-20000\n");
  TerrainParams raster = terrainOf(TerrainKind::raster);
  raster.transform_file = "x.json";
  SceneParams scene = sceneWith({raster});
  scene.folder = folder.path();
  for (const char* name : {"x_2x2_float32.raw.gz", "x.csv"})
  {
    scene.terrains[0].file = name;
    try
    {
      buildTerrain(scene);
      ADD_FAILURE() << name << " was taken";
    }
    catch (const std::runtime_error& e)
    {
      EXPECT_NE(std::string(e.what()).find("within 10 km"), std::string::npos) << e.what();
    }
  }
}

TEST(Raster, OfPointsHasAMillionNodes)
{
  TerrainParams raster = terrainOf(TerrainKind::raster);
  raster.file = "missing.csv";
  raster.spacing_m = 0.1;
  SceneParams scene = sceneWith({raster});
  scene.extent = {};
  scene.extent.min_x_m = scene.extent.min_y_m = -60;
  scene.extent.max_x_m = scene.extent.max_y_m = 60;  // 1201 x 1201
  try
  {
    buildTerrain(scene);
    ADD_FAILURE();
  }
  catch (const std::runtime_error& e)
  {
    EXPECT_NE(std::string(e.what()).find("spacing_m"), std::string::npos) << e.what();
  }
}
}  // namespace
