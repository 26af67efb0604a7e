// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <support/drive_free.h>
#include <support/scene_words.h>

// What holds for every random scene.
namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

constexpr uint64_t kSeeds = 20;
constexpr uint64_t kFewSeeds = 8;

TEST(RandomScene, IsTheSameForASeed)
{
  for (uint64_t seed = 1; seed <= 3; ++seed)
  {
    const SceneParams once = randomScene(seed);
    EXPECT_EQ(once, randomScene(seed));
    EXPECT_EQ(vertexBytes(buildScene(once)), vertexBytes(buildScene(randomScene(seed))));
  }
  EXPECT_NE(randomScene(1), randomScene(2));
}

TEST(RandomScene, ReadsBackFromItsText)
{
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    const SceneParams scene = randomScene(seed);
    const std::string text = simulating::sceneText(scene);
    const SceneParams again =
        simulating::readScene(config::IniDocument::fromText(text, "text.ini"));
    EXPECT_EQ(scene, again) << seed;
    EXPECT_EQ(text, simulating::sceneText(again)) << seed;
  }
}

TEST(RandomScene, KeepsTheDriveFree)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const SceneParams words = randomScene(seed);
    const Scene scene = buildScene(words);
    for (const Object& object : scene.objects)
    {
      // clods are no thing that a vehicle avoids, but they stay off its way too, all but a little
      const double free = object.label == Label::lump ? 1.2 : 1.5;
      EXPECT_GE(nearestLow(words, scene, object), free)
          << "seed " << seed << " " << object.name << " " << nameOf(object.label);
    }
  }
}

TEST(RandomScene, IsClosedAndOfABoundedSize)
{
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    size_t triangles = 0;
    for (const Object& object : buildScene(randomScene(seed)).objects)
    {
      for (const Part& part : object.parts)
      {
        triangles += part.triangles.size();
        EXPECT_TRUE(!part.solid || isClosed(part)) << seed << " " << object.name;
      }
    }
    EXPECT_LT(triangles, 1500000U);
    EXPECT_GT(triangles, 5000U);
  }
}

/** Near the way there is ground of each kind that the map must tell apart. */
TEST(RandomScene, HasEveryClassNearTheWay)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const SceneParams words = randomScene(seed);
    const Scene scene = buildScene(words);
    std::set<Label> near;
    for (const Object& object : scene.objects)
    {
      if (nearestLow(words, scene, object) < 12)
      {
        near.insert(object.label);
      }
    }
    for (int i = 0; i < 22500; ++i)
    {
      const int row = i / 150;
      const Eigen::Vector2d place(-30 + 0.4 * (i % 150), -30 + 0.4 * row);
      const Label label = scene.terrain->at(place.x(), place.y()).label;
      if (near.count(label) == 0 && fromDrive(words, place) < 8)
      {
        near.insert(label);
      }
    }
    EXPECT_TRUE(near.count(Label::road) && near.count(Label::ground)) << seed;
    EXPECT_TRUE(near.count(Label::bank)) << seed;
    EXPECT_TRUE(near.count(Label::lump) && near.count(Label::rut)) << seed;
    EXPECT_TRUE(near.count(Label::tree)) << seed;
  }
}

/** The road's slope is one that a car takes. */
TEST(RandomScene, HasRoadsThatCanBeDriven)
{
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    const SceneParams words = randomScene(seed);
    const auto terrain = buildTerrain(words);
    for (size_t i = 0; i + 1 < words.drive_xs_m.size(); ++i)
    {
      const double dx = words.drive_xs_m[i + 1] - words.drive_xs_m[i];
      const double dy = words.drive_ys_m[i + 1] - words.drive_ys_m[i];
      const double rise = terrain->at(words.drive_xs_m[i + 1], words.drive_ys_m[i + 1]).base_m -
                          terrain->at(words.drive_xs_m[i], words.drive_ys_m[i]).base_m;
      EXPECT_LT(std::abs(rise), 0.2 * std::sqrt(dx * dx + dy * dy)) << seed;
    }
  }
}

TEST(RandomScene, KeepsTheFixedOnesFirst)
{
  SceneParams fixed = sceneWith({terrainOf(TerrainKind::hills)});
  fixed.extent.min_x_m = fixed.extent.min_y_m = -30;
  fixed.extent.max_x_m = fixed.extent.max_y_m = 30;
  fixed.objects = {objectOf(ObjectKind::table)};
  EXPECT_EQ(generate(fixed, 1), fixed);  // its style is none
  fixed.random.style = RandomStyle::paper_3;
  const SceneParams scene = generate(fixed, 1);
  EXPECT_EQ(scene.terrains.at(0), fixed.terrains.at(0));
  EXPECT_EQ(scene.objects.at(0).kind, ObjectKind::table);
  EXPECT_GT(scene.objects.size(), 10U);
  EXPECT_EQ(generate(scene, 2), scene);  // explicit now
}

TEST(RandomScene, RefusesAnAreaThatIsTooSmall)
{
  SceneParams small = sceneWith({});
  small.random.style = RandomStyle::paper_3;
  try
  {
    generate(small, 1);
    FAIL() << "was accepted";
  }
  catch (const std::runtime_error& e)
  {
    EXPECT_NE(std::string(e.what()).find("[Random] drive_m"), std::string::npos) << e.what();
  }
}

/** Rays ask for the look of the ground alone. */
TEST(RandomScene, GroundLooksAsItIs)
{
  for (uint64_t seed = 1; seed <= 3; ++seed)
  {
    const auto terrain = buildScene(randomScene(seed)).terrain;
    for (int i = 0; i < 10000; ++i)
    {
      const int row = i / 100;
      const double x = -35 + (i % 100) * 0.71;
      const double y = -35 + row * 0.71;
      ASSERT_EQ(terrain->look(x, y).label, terrain->at(x, y).label) << x << " " << y;
      ASSERT_EQ(terrain->look(x, y).material, terrain->at(x, y).material) << x << " " << y;
    }
  }
}
}  // namespace
