// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/truth.h>

#include <gtest/gtest.h>

#include <set>
#include <support/drive_free.h>

// What holds for every street of ini/scenes/paper_5.ini.
namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

constexpr uint64_t kSeeds = 20;
constexpr uint64_t kFewSeeds = 6;

SceneParams asked()
{
  SceneParams scene = simulating::readScene(config::IniDocument::fromFile(
      std::filesystem::path(TRAVERSE_SOURCE_DIR) / "ini/scenes/paper_5.ini"));
  scene.folder.clear();  // it is none of a scene's text
  return scene;
}

SceneParams street(uint64_t seed)
{
  return generate(asked(), seed);
}

/** What of the scene moves, or what stands. */
Scene partOf(const Scene& scene, bool moves)
{
  Scene part{scene.area, scene.terrain, {}};
  std::copy_if(
      scene.objects.begin(), scene.objects.end(), std::back_inserter(part.objects),
      [&](const Object& o) { return o.motion.moves() == moves; });
  return part;
}

double fromEdges(const Eigen::Vector2d& place, const Outline& outline)
{
  double nearest = 1e9;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d edge = outline[(i + 1) % outline.size()] - a;
    const double along = std::clamp((place - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (place - a - along * edge).norm());
  }
  return nearest;
}

double apart(const Outline& a, const Outline& b)
{
  double nearest = 1e9;
  for (const Eigen::Vector2d& corner : a)
  {
    nearest = std::min(nearest, fromEdges(corner, b));
  }
  for (const Eigen::Vector2d& corner : b)
  {
    nearest = std::min(nearest, fromEdges(corner, a));
  }
  return nearest;
}

std::vector<Outline> outlinesOf(const std::vector<Footprint>& things)
{
  std::vector<Outline> outlines;
  for (const Footprint& thing : things)
  {
    outlines.insert(outlines.end(), thing.outlines.begin(), thing.outlines.end());
  }
  return outlines;
}

double nearest(const std::vector<Outline>& some, const std::vector<Outline>& others)
{
  double nearest = 1e9;
  for (const Outline& one : some)
  {
    for (const Outline& other : others)
    {
      nearest = std::min(nearest, apart(one, other));
    }
  }
  return nearest;
}

TEST(RandomStreet, IsTheSameForASeedAndReadsBackFromItsText)
{
  for (uint64_t seed = 1; seed <= kSeeds; ++seed)
  {
    const SceneParams scene = street(seed);
    EXPECT_EQ(scene, street(seed));
    const std::string text = simulating::sceneText(scene);
    EXPECT_EQ(scene, simulating::readScene(config::IniDocument::fromText(text, "text.ini")));
  }
  EXPECT_NE(street(1), street(2));
}

TEST(RandomStreet, KeepsTheDriveFree)
{
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const SceneParams words = street(seed);
    const Scene scene = buildScene(words);
    for (const Object& object : scene.objects)
    {
      EXPECT_GE(nearestLow(words, scene, object), 1.5) << "seed " << seed << " " << object.name;
    }
  }
}

/** So that a cell which something moving left is free: none of what stands is in it. */
TEST(RandomStreet, WhatMovesStaysOffWhatStands)
{
  const geometry::Vehicle vehicle;
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const Scene scene = buildScene(street(seed));
    const Scene movers = partOf(scene, true);
    const std::vector<Outline> standing = outlinesOf(footprints(partOf(scene, false), vehicle, 0));
    for (int time_s = 0; time_s < 20; ++time_s)
    {
      // a diagonal of a cell of 0.2 m
      EXPECT_GT(nearest(outlinesOf(footprints(movers, vehicle, time_s)), standing), 0.283) << seed;
    }
  }
}

TEST(RandomStreet, HasWhatTheMapMustTellApart)
{
  std::set<Label> labels;
  std::set<TerrainKind> ground;
  for (uint64_t seed = 1; seed <= kFewSeeds; ++seed)
  {
    const SceneParams words = street(seed);
    const Scene scene = buildScene(words);
    size_t moving = 0;
    for (const Object& object : scene.objects)
    {
      labels.insert(object.label);
      moving += object.motion.moves() ? 1 : 0;
    }
    EXPECT_GE(moving, 6U) << seed;
    for (const TerrainParams& piece : words.terrains)
    {
      ground.insert(piece.kind);
    }
  }
  for (const Label label :
       {Label::vehicle, Label::person, Label::wall, Label::building, Label::pole, Label::tree,
        Label::structure, Label::fence})
  {
    EXPECT_TRUE(labels.contains(label)) << nameOf(label);
  }
  EXPECT_TRUE(ground.contains(TerrainKind::ditch) && ground.contains(TerrainKind::hole));
  EXPECT_TRUE(ground.contains(TerrainKind::kerb));
}

TEST(RandomStreet, RefusesAnAreaThatIsTooSmall)
{
  SceneParams small = asked();
  small.extent.max_x_m = 60;
  EXPECT_THROW(generate(small, 1), std::runtime_error);
}
}  // namespace
