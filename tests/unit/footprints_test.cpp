// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/bytes.h>
#include <traverse/formats/geojson.h>
#include <traverse/simulation/footprints.h>

#include <gtest/gtest.h>

#include <support/truth_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

double areaOf(const Outline& outline)
{
  double twice = 0;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& p = outline[i];
    const Eigen::Vector2d& q = outline[(i + 1) % outline.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

TEST(Footprints, BoxHasItsRectangle)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{1, 1, 0}, {2, 3, 1.5F}}, Label::vehicle));
  const std::vector<Footprint> all = footprints(scene, geometry::Vehicle{}, 0);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].object, Scene::kFirstObject);
  EXPECT_EQ(all[0].label, Label::vehicle);
  EXPECT_DOUBLE_EQ(all[0].height_m, 1.5);
  ASSERT_EQ(all[0].outlines.size(), 1U);
  EXPECT_EQ(all[0].outlines[0].size(), 4U);
  EXPECT_DOUBLE_EQ(areaOf(all[0].outlines[0]), 2);
}

TEST(Footprints, CrownsAboveTheVehicleDoNotCount)
{
  Scene scene = levelScene();
  Object tree = boxObject({{0, 0, 0}, {0.4F, 0.4F, 4}}, Label::tree);
  tree.parts.push_back(boxPart({{-2, -2, 3}, {2, 2, 5}}, Material::foliage));
  scene.objects.push_back(tree);
  const std::vector<Footprint> all = footprints(scene, geometry::Vehicle{}, 0);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].outlines.size(), 1U);
  EXPECT_NEAR(areaOf(all[0].outlines[0]), 0.16, 1e-6);  // corners are floats
  EXPECT_DOUBLE_EQ(all[0].height_m, 2);                 // the vehicle's
}

TEST(Footprints, WhatHangsHighOrGivesWayHasNone)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{0, 0, 3}, {2, 2, 3.5F}}, Label::structure));
  scene.objects.push_back(grassObject({{0, 0, 0}, {1, 1, 0}}, 0.5F));
  EXPECT_TRUE(footprints(scene, geometry::Vehicle{}, 0).empty());
}

TEST(Footprints, PiecesApartHaveOutlinesOfTheirOwn)
{
  Scene scene = levelScene();
  Object gate = boxObject({{0, 0, 0}, {0.2F, 0.2F, 1}});
  gate.parts.push_back(boxPart({{2, 0, 0}, {2.2F, 0.2F, 1}}));
  gate.parts.push_back(boxPart({{2.05F, 0.05F, 0}, {2.1F, 0.1F, 1}}));  // within the second
  scene.objects.push_back(gate);
  const std::vector<Footprint> all = footprints(scene, geometry::Vehicle{}, 0);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].outlines.size(), 2U);
}

TEST(Footprints, BallOnTheGroundHasItsCircle)
{
  Scene scene = levelScene();
  Object ball;
  ball.balls.push_back({{1, 1, 0}, 0.5F, Material::snow});
  scene.objects.push_back(ball);
  const std::vector<Footprint> all = footprints(scene, geometry::Vehicle{}, 0);
  ASSERT_EQ(all.size(), 1U);
  // a 32-gon within the circle: sin(2 pi / 32) * 16 / pi of its area
  EXPECT_NEAR(areaOf(all[0].outlines[0]), 3.14159265 * 0.25 * 0.99359, 1e-4);
}

TEST(SweptCells, MarksTheWayOfWhatMoves)
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{-0.19F, -0.19F, 0}, {0.19F, 0.19F, 1}}));
  TimedPose from;
  TimedPose to;
  from.T_map_body.translation() = Eigen::Vector3d(-2, 0.2, 0);
  to.T_map_body.translation() = Eigen::Vector3d(2, 0.2, 0);
  to.t_s = 4;
  scene.objects[0].motion = Motion({from, to});
  scene.objects.push_back(boxObject({{-3, -3, 0}, {-2, -2, 1}}));
  const layers::LayerSet set = sweptCells(scene, TruthParams{}, 0, 2);
  const auto& cells = std::get<std::vector<uint8_t>>(set.find("truth_swept")->data);
  size_t marked = 0;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    const size_t row = i / 40;
    EXPECT_TRUE(cells[i] == 0 || row == 20 || row == 21);
    marked += cells[i];
  }
  EXPECT_EQ(marked, 2U * 12);  // x from -2.19 to 0.19: cells -11 to 0
}

TEST(GeoJson, ReadsBackWhatItWrote)
{
  const std::vector<formats::Feature> features = {
      {{{{0, 0}, {1, 0}, {1, 2.5}}, {{5, 5}, {6, 5}, {6, 6}}},
       {{"name", std::string("a \"b\"")}, {"height_m", 1.25}}}};
  const std::string text = formats::geoJson(features);
  const auto back = formats::parseGeoJson(text, "f");
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].polygons, features[0].polygons);
  EXPECT_EQ(back[0].properties, features[0].properties);
  EXPECT_EQ(formats::geoJson(back), text);
}

TEST(GeoJson, RefusesWhatIsNone)
{
  const auto refused = [](const std::string& text)
  { EXPECT_THROW(formats::parseGeoJson(text, "f"), formats::FormatError) << text; };
  const auto with = [](const std::string& geometry)
  {
    return R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":null,"geometry":)" +
           geometry + "}]}";
  };
  refused("");
  refused("[]");
  refused("{\"type\":\"FeatureCollection\"}");
  refused(with(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1]]]})"));  // open
  refused(with(R"({"type":"Polygon","coordinates":[[[0,0],[1e99,0],[1,1],[0,0]]]})"));
  refused(with(R"({"type":"Polygon","coordinates":[[[0,0],["a",0],[1,1],[0,0]]]})"));
  refused(with(R"({"type":"Polygon","coordinates":[]})"));
  refused(with(R"({"type":"Polygon"})"));
  refused(with(R"({"type":7})"));
  refused(R"({"type":"FeatureCollection","features":[1]})");
  refused(std::string(100000, '['));
  EXPECT_TRUE(formats::parseGeoJson(with(R"({"type":"Point","coordinates":[0,0]})"), "f").empty());
  EXPECT_TRUE(formats::parseGeoJson(with("null"), "f").empty());
}
}  // namespace
