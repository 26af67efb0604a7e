// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/geojson.h>
#include <traverse/simulation/truth_files.h>

#include <gtest/gtest.h>

#include <support/truth_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::simulation;
using namespace traverse::testing;

/** A box that stands, and one that goes 1 m/s along x for two seconds. */
Scene boxes()
{
  Scene scene = levelScene();
  scene.objects.push_back(boxObject({{-3, -3, 0}, {-2, -2, 1}}));
  scene.objects.push_back(boxObject({{0, 0, 0}, {0.5F, 0.5F, 1}}));
  TimedPose end;
  end.t_s = 2;
  end.T_map_body.translation().x() = 2;
  scene.objects[1].motion = Motion({TimedPose{}, end});
  return scene;
}

TEST(MovingThings, AreWhereTheyAreEveryTenthOfASecond)
{
  const TruthFile file = movingThings(boxes(), geometry::Vehicle{}, 1);
  EXPECT_EQ(file.name, "moving.geojson");
  const auto features = formats::parseGeoJson(file.bytes, file.name);
  ASSERT_EQ(features.size(), 11U);
  const double start_s = std::get<double>(features[0].properties.at("time_s"));
  EXPECT_EQ(start_s, 1'577'836'800.0);  // the log's clock: 2020-01-01
  for (size_t i = 0; i < features.size(); ++i)
  {
    const auto& properties = features[i].properties;
    EXPECT_EQ(std::get<double>(properties.at("object")), Scene::kFirstObject + 1.0);
    // a double of this size has 0.24 us
    EXPECT_NEAR(
        std::get<double>(properties.at("time_s")), start_s + 0.1 * static_cast<double>(i), 1e-6);
    double west_m = 1e9;
    for (const Eigen::Vector2d& corner : features[i].polygons.at(0))
    {
      west_m = std::min(west_m, corner.x());
    }
    EXPECT_NEAR(west_m, 0.1 * static_cast<double>(i), 2e-6);  // the file has whole micrometres
  }
}

TEST(MovingThings, OfAStandingSceneAreNone)
{
  Scene scene = boxes();
  scene.objects.pop_back();
  const TruthFile file = movingThings(scene, geometry::Vehicle{}, 1);
  EXPECT_TRUE(formats::parseGeoJson(file.bytes, file.name).empty());
}

TEST(CheckTruth, RefusesWhatCellTruthWould)
{
  const Scene scene = boxes();
  EXPECT_NO_THROW(checkTruth(scene, TruthParams{}, {0, 0}));
  EXPECT_THROW(checkTruth(scene, TruthParams{}, {1e6, 0}), std::invalid_argument);
  EXPECT_THROW(checkTruth(Scene{}, TruthParams{}, {0, 0}), std::invalid_argument);
  TruthParams params;
  params.flat_max_m = 0.2;
  EXPECT_THROW(checkTruth(scene, params, {0, 0}), options::OptionError);
  Scene wide = scene;
  wide.area = {-2000, -2000, 2000, 2000};
  EXPECT_THROW(checkTruth(wide, TruthParams{}, {0, 0}), std::length_error);
}
}  // namespace
