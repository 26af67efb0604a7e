// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/explain.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;

const geometry::Vehicle kCar;

Params paper()
{
  Params params;
  params.classifier = ClassifierKind::paper;
  return params;
}

struct Drawn
{
  Params params;
  State state;

  explicit Drawn(const Picture& picture, const Params& with = paper()) :
      params(with), state(makeState(params, kCar))
  {
    update(state, draw(picture).view(), Eigen::Isometry3d::Identity(), params, kCar);
  }

  /** All values of one key of the picture's cell. */
  std::string why(int32_t x, const std::string& key, int32_t y = 0) const
  {
    std::string all;
    for (const layers::Fact& fact : explain(state, params, kCar, {x, y}))
    {
      all += fact.key.starts_with(key) ? fact.value + "\n" : "";
    }
    return all;
  }
};

TEST(TraversabilityExplain, NamesTheThresholdThatDecided)
{
  const Drawn map({".sl#1"});
  EXPECT_THAT(map.why(0, "decided by"), HasSubstr("within all limits of flat"));
  EXPECT_EQ(
      map.why(1, "decided by"),
      "deviation_m = 0.036, above flat_max_deviation_m = 0.03\n"
      "variance_m2 = 0.000864, above flat_max_variance_m2 = 0.000225\n")
      << "10 of 25 points 6 cm higher";
  EXPECT_THAT(
      map.why(2, "decided by"), HasSubstr("deviation_m = 0.12, above small_max_deviation_m = 0.1"));
  EXPECT_THAT(
      map.why(3, "decided by"),
      HasSubstr("deviation_m = 0.96, above large_max_deviation_m = 0.25"));
  EXPECT_EQ(map.why(4, "decided by"), "points = 2, below min_points = 3\n");
}

TEST(TraversabilityExplain, SaysTheClassAndIndexOfTheLayers)
{
  const Drawn map({".sl#1"});
  EXPECT_EQ(map.why(0, "class"), "flat (1)\n");
  EXPECT_EQ(map.why(3, "class"), "obstacle (4)\n");
  EXPECT_EQ(map.why(3, "index"), "100\n");
  EXPECT_EQ(map.why(4, "class"), "undefined (0)\n");
  EXPECT_EQ(map.why(4, "index"), "none\n");
}

TEST(TraversabilityExplain, ListsEachSlabAndWhatIsLeftOutOfIt)
{
  const Drawn map({"b"});
  EXPECT_EQ(map.why(0, "points"), "25\n") << "not those of the branch";
  EXPECT_EQ(
      map.why(0, "slab 0 m to 0.5 m"),
      "n = 25, min 0 m, max 0 m, last seen 1600000000.000000000 s since 1970 by a sensor without "
      "label\n");
  EXPECT_THAT(
      map.why(0, "slab 2 m to 2.5 m"),
      AllOf(HasSubstr("n = 25, min 2.4 m"), HasSubstr("left out: above a gap")));
}

TEST(TraversabilityExplain, AnswersForCellsThatHaveNothing)
{
  EXPECT_THAT(Drawn({". ."}).why(1, "decided by"), HasSubstr("never seen"));
  EXPECT_THAT(Drawn({"."}).why(100000, "decided by"), HasSubstr("window"));
  Params fixed;
  fixed.extent = Extent::fixed;
  EXPECT_THAT(Drawn({"."}, fixed).why(100000, "decided by"), HasSubstr("outside the map"));
  Params growing;
  growing.extent = Extent::growing;
  EXPECT_THAT(Drawn({"."}, growing).why(100000, "decided by"), HasSubstr("never seen"));
}

/** Level points of one cell. */
void addLevel(points::ScanBuffer& scan, double x, double y, double z)
{
  for (const double u : {0.03, 0.09, 0.15})
  {
    for (const double v : {0.03, 0.09, 0.15})
    {
      addPoint(scan, x + u, y + v, z);
    }
  }
}

/** Level ground around the vehicle with a plate of a square metre in the air. */
points::ScanBuffer plateScan(double z_m)
{
  points::ScanBuffer scan;
  scan.T_base_sensor.translation().z() = 1.7;
  scan.sensor_label = "TOP\n";
  const auto is_plate = [](int k) { return k >= 40 && k < 45; };
  for (int column = 0; column < 50; ++column)
  {
    for (int row = 0; row < 50; ++row)
    {
      addLevel(
          scan, -5 + 0.2 * column, -5 + 0.2 * row, is_plate(column) && is_plate(row) ? z_m : 0);
    }
  }
  return scan;
}

/** The explanation of the plate's middle. */
std::string plateAt(double z_m)
{
  const Params params;
  State state = makeState(params, kCar);
  update(state, plateScan(z_m).view(), Eigen::Isometry3d::Identity(), params, kCar);
  std::string all;
  for (const layers::Fact& fact : explain(state, params, kCar, {17, 17}))
  {
    all += fact.key + ": " + fact.value + "\n";
  }
  return all;
}

TEST(TraversabilityExplain, SaysWhereTheGroundDecided)
{
  const std::string table = plateAt(0.8);
  EXPECT_THAT(table, HasSubstr("class: obstacle (4)\n"));
  EXPECT_THAT(table, HasSubstr("ground: 0 m\n"));
  EXPECT_THAT(
      table, HasSubstr("decided by: lowest point 0.8 m above the ground, more than "
                       "large_max_deviation_m = 0.25\n"));
  const std::string bridge = plateAt(4);
  EXPECT_THAT(bridge, HasSubstr("class: undefined (0)\n"));
  EXPECT_THAT(bridge, HasSubstr("decided by: all points hang 4 m above the ground"));
}

TEST(TraversabilityExplain, NamesTheSensorWithoutItsControlCharacters)
{
  EXPECT_THAT(plateAt(0.8), HasSubstr(" by TOP?\n"));
}

TEST(TraversabilityExplain, ACellWithoutAPlaneIsUndefinedForThatReason)
{
  const Params params = paper();
  State state = makeState(params, kCar);
  points::ScanBuffer line;
  for (int i = 0; i < 5; ++i)
  {
    addPoint(line, 0.02 + 0.04 * i, 0.1, 0);
  }
  update(state, line.view(), Eigen::Isometry3d::Identity(), params, kCar);
  const auto facts = explain(state, params, kCar, {0, 0});
  const auto decided = std::find_if(
      facts.begin(), facts.end(), [](const layers::Fact& f) { return f.key == "decided by"; });
  ASSERT_NE(decided, facts.end());
  EXPECT_THAT(decided->value, HasSubstr("no plane fits"));
}

TEST(TraversabilityExplain, SomethingDecidesInEveryCellOfAnyMap)
{
  std::mt19937 random(8);
  Params params;
  State state = makeState(params, kCar);
  update(state, randomScan(random, 20000).view(), Eigen::Isometry3d::Identity(), params, kCar);
  state.cells.forEach(
      [&](Cells::Place place)
      {
        size_t reasons = 0;
        for (const layers::Fact& f : explain(state, params, kCar, state.cells.indexOf(place)))
        {
          reasons += static_cast<size_t>(f.key == "decided by");
        }
        EXPECT_GE(reasons, 1U);
      });
}
}  // namespace
