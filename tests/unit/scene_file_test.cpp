// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>

#include <gtest/gtest.h>

#include <support/data.h>
#include <support/scene_words.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

SceneParams read(const std::string& text)
{
  return simulating::readScene(config::IniDocument::fromText(text, "scene.ini"));
}

std::string refusal(const std::string& text)
{
  try
  {
    read(text);
  }
  catch (const config::ConfigError& e)
  {
    return e.what();
  }
  return "accepted";
}

TEST(SceneFile, ReadsNumberedSectionsInTheirOrder)
{
  const SceneParams scene = read(
      "[Object_01]\nkind = tree\n[Scene]\ntitle = Two things\nmax_x_m = 20\n"
      "[Object_00]\nkind = box\nmaterial = snow\n[Terrain_00]\nkind = bank\nlabel = lump\n"
      "[Lidar_00]\nmodel = of others\n[Drive]\nxs_m = 1 2\nys_m = 3 4\nspeed_mps = 5\n");
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects.at(0).kind, ObjectKind::box);
  EXPECT_EQ(scene.objects.at(0).material, choose(Material::snow));
  EXPECT_EQ(scene.objects.at(1).kind, ObjectKind::tree);
  EXPECT_EQ(scene.terrains.at(0).label, choose(Label::lump));
  EXPECT_EQ(scene.extent.title, "Two things");
  EXPECT_EQ(scene.drive_ys_m, (std::vector<double>{3, 4}));
}

TEST(SceneFile, RefusesWhatItDoesNotKnow)
{
  EXPECT_EQ(
      refusal("[Object_00]\nkind = box\nhight_m = 1\n"),
      "scene.ini:3: [Object_00] unknown key 'hight_m'; did you mean 'height_m'?");
  EXPECT_NE(
      refusal("[Terrain_00]\nkind = swamp\n").find("[Terrain_00] kind = 'swamp'"),
      std::string::npos);
  EXPECT_NE(
      refusal("[Object_00]\nkind = box\nlength_m = -1\n").find("length_m = '-1'"),
      std::string::npos);
  for (const char* section :
       {"Object_1", "Object_x", "Objects", "Terrain_", "Terrain00", "Scenes", "Random_2",
        "Missions", "Object_02"})
  {
    const std::string message = refusal(std::string("[") + section + "]\nkind = box\n");
    EXPECT_NE(message.find(section), std::string::npos) << section << ": " << message;
  }
}

TEST(SceneFile, ReadsMissions)
{
  const MissionParams mission = read(
                                    "[Mission]\nstart_x_m = 1\nstart_yaw_deg = 90\n"
                                    "goal_xs_m = 5 5\ngoal_ys_m = 0 3\n")
                                    .mission;
  EXPECT_DOUBLE_EQ(startOf(mission).yaw_rad, M_PI / 2);
  const std::vector<geometry::Pose2> goals = goalsOf(mission);
  ASSERT_EQ(goals.size(), 2U);
  EXPECT_EQ(goals.at(0).x_m, 5);
  EXPECT_DOUBLE_EQ(goals.at(0).yaw_rad, 0);  // as it comes from the start
  EXPECT_DOUBLE_EQ(goals.at(1).yaw_rad, M_PI / 2);
  EXPECT_TRUE(goalsOf(read("").mission).empty());
  EXPECT_THROW(goalsOf(read("[Mission]\ngoal_xs_m = 1\n").mission), options::OptionError);
}

TEST(SceneFile, WritesOnlyTextsThatReadBack)
{
  SceneParams scene = sceneWith({});
  scene.extent.title = "street, 50 % grass; \"old\" [x] = #1";
  EXPECT_EQ(read(simulating::sceneText(scene)), scene);
  for (const char* title : {"a // b", "$env{HOME}", "two\nlines", " blank", "end\\", "@define a"})
  {
    scene.extent.title = title;
    EXPECT_THROW(simulating::sceneText(scene), config::ConfigError) << title;
  }
}

TEST(SceneFile, KeepsEveryNumber)
{
  SceneParams scene = sceneWith({terrainOf(TerrainKind::ramp)});
  scene.terrains.at(0).height_m = 0.1 + 0.2;
  scene.terrains.at(0).xs_m = {1.0 / 3, -1e-17, 12345.6789};
  EXPECT_EQ(read(simulating::sceneText(scene)), scene);
}

TEST(SceneFile, ScenesOfTheProjectCanBeBuilt)
{
  const std::filesystem::path folder = std::filesystem::path(TRAVERSE_SOURCE_DIR) / "ini/scenes";
  for (const char* name :
       {"street", "fence_and_grass", "ditches", "overhangs", "paper_3", "paper_5", "clutter",
        "park", "tunnel", "warehouse", "icy_lot"})
  {
    const auto ini = config::IniDocument::fromFile(folder / (std::string(name) + ".ini"));
    const Scene scene = buildScene(generate(simulating::readScene(ini), 1));
    EXPECT_GT(scene.objects.size(), 3U) << name;
  }
}

TEST(SceneFile, SurveyedGroundCanBeBuilt)
{
  TRAVERSE_NEEDS(sharedData("argoverse2-2xVLP32C"));
  // its paths are those of a source tree that stands beside the data
  TRAVERSE_NEEDS(std::filesystem::path(TRAVERSE_SOURCE_DIR) / "../shared/data/argoverse2-2xVLP32C");
  const auto ini = config::IniDocument::fromFile(
      std::filesystem::path(TRAVERSE_SOURCE_DIR) / "ini/scenes/argoverse_ground.ini");
  const Scene scene = buildScene(simulating::readScene(ini));
  EXPECT_NE(scene.terrain->at(20, -10).height_m, 0);
}
}  // namespace
