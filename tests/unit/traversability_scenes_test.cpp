// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const geometry::Vehicle kCar;

Params growing()
{
  Params params;
  params.extent = Extent::growing;
  return params;
}

Picture classified(const Picture& scene, const Params& params = growing())
{
  State state = makeState(params, kCar);
  update(state, draw(scene).view(), atPlace(0, 0), params, kCar);
  const auto height = static_cast<int32_t>(scene.size());
  const auto width = static_cast<int32_t>(scene.front().size());
  return classes(layerSet(state, params, kCar, geometry::CellRect{{0, 0}, {width, height}}));
}

TEST(Scene, LevelGroundIsFlatAndNothingIsUndefined)
{
  EXPECT_THAT(classified({"..  ", " .1 "}), ElementsAre("11  ", " 1  "));
}

TEST(Scene, StepsAreRoughByTheirHeight)
{
  EXPECT_THAT(classified({".s.l."}), ElementsAre("12131"));
}

TEST(Scene, AWallIsAnObstacleThoughItHasNoPlane)
{
  EXPECT_THAT(classified({".#.", ".#."}), ElementsAre("141", "141"));
}

TEST(Scene, VarianceTellsAFenceFromGrassOfTheSameHeight)
{
  Params params = growing();
  params.classifier = ClassifierKind::paper;  // the default one wants more grass than one cell
  params.large_roughness.deviation_m = 0.32;  // so that the deviation does not decide
  params.large_roughness.slope_deg = 89;
  EXPECT_THAT(classified({"g.f"}, params), ElementsAre("314"));
}

TEST(Scene, ABranchAboveTheVehicleIsNoObstacle)
{
  EXPECT_THAT(classified({".b.t."}), ElementsAre("11141"))
      << "the vehicle, 2 m high, fits under the branch, not under the table";
}

TEST(Scene, ThePaperToTheLetterCountsWhatHangs)
{
  Params params = growing();
  params.ignore_overhangs = false;
  EXPECT_THAT(classified({".b."}, params), ElementsAre("141"));
}

TEST(Scene, PointsOnALineThatAreLevelAreUndefinedToThePaper)
{
  Params params = growing();
  params.classifier = ClassifierKind::paper;
  State state = makeState(params, kCar);
  points::ScanBuffer line;
  for (int i = 0; i < 10; ++i)
  {
    addPoint(line, 0.01 + 0.015 * i, 0.1, 0.5);
  }
  update(state, line.view(), atPlace(0, 0), params, kCar);
  EXPECT_EQ(state.cells.get({0, 0})->of, Class::undefined) << "a slope across could be anything";
  EXPECT_EQ(state.cells.get({0, 0})->index, kNoIndex);
}

TEST(Update, ASingleCloudMapShowsTheLastCloudOnly)
{
  Params params = growing();
  params.mode = Mode::single_cloud;
  State state = makeState(params, kCar);
  update(state, draw({"..."}).view(), atPlace(0, 0), params, kCar);
  update(state, draw({" #"}).view(), atPlace(0, 0), params, kCar);
  EXPECT_EQ(state.occupied, 1U);
  const geometry::CellRect three{{0, 0}, {3, 1}};
  EXPECT_THAT(classes(layerSet(state, params, kCar, three)), ElementsAre(" 4 "));
}

TEST(Update, AnAccumulatedMapAddsUp)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  update(state, draw({"1.."}).view(), atPlace(0, 0), params, kCar);
  update(state, draw({"1 #"}).view(), atPlace(0, 0), params, kCar);
  const layers::LayerSet set = layerSet(state, params, kCar);
  EXPECT_THAT(
      std::get<std::vector<uint32_t>>(set.find("point_count")->data), ElementsAre(4, 25, 50));
}

TEST(Update, BadPointsAreSkippedAndCounted)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  points::ScanBuffer scan = draw({"."});
  const double nan = std::nan("");
  addPoint(scan, nan, 0, 0);
  addPoint(scan, 0, 0, INFINITY);
  addPoint(scan, 3e38, 0, 0);
  addPoint(scan, 500, 0, 0);
  addPoint(scan, 0, 0, 40);
  const layers::UpdateStats stats = update(state, scan.view(), atPlace(0, 0), params, kCar);
  EXPECT_EQ(stats.points, 25U);
  EXPECT_EQ(stats.bad_points, 3U);
  EXPECT_EQ(stats.outside, 2U) << "beyond the neighbourhood, and above highest_m";
  EXPECT_EQ(stats.touched_cells, 1U);
  EXPECT_TRUE(stats.inserted);
}

TEST(Update, AScanWithoutAUsablePointOrPoseChangesNothing)
{
  Params params = growing();
  params.mode = Mode::single_cloud;
  State state = makeState(params, kCar);
  update(state, draw({"."}).view(), atPlace(0, 0), params, kCar);
  const std::string before = archive(state, params, kCar);
  points::ScanBuffer bad;
  addPoint(bad, std::nan(""), 0, 0);
  EXPECT_FALSE(update(state, bad.view(), atPlace(0, 0), params, kCar).inserted);
  const points::ScanBuffer good = draw({"#"});
  Eigen::Isometry3d scaled = atPlace(0, 0);
  scaled.linear() *= 2;
  for (const Eigen::Isometry3d& T : {atPlace(NAN, 0), atPlace(1e9, 0), scaled})
  {
    const layers::UpdateStats stats = update(state, good.view(), T, params, kCar);
    EXPECT_FALSE(stats.inserted);
    EXPECT_TRUE(stats.no_pose);
  }
  EXPECT_EQ(archive(state, params, kCar), before);
}

TEST(Update, TheMemoryBudgetIsKeptAndWhatItRefusesIsCounted)
{
  Params params = growing();
  params.max_memory_mb = 1;  // 30 tiles of cells
  State state = makeState(params, kCar);
  uint64_t refused = 0;
  for (int i = 0; i < 50; ++i)
  {
    const layers::UpdateStats stats =
        update(state, draw({"."}).view(), atPlace(100 * i, 0), params, kCar);
    refused += stats.over_budget;
    EXPECT_EQ(stats.over_budget + stats.points, 25U);
    EXPECT_EQ(stats.inserted, stats.points > 0);
  }
  EXPECT_EQ(state.cells.tiles(), mostTiles(params));
  EXPECT_EQ(refused, 25 * (50 - mostTiles(params)));
}

TEST(Update, AFixedMapKeepsToItsRectangle)
{
  Params params;
  params.extent = Extent::fixed;
  params.fixed_min_x_m = 0.2;
  params.fixed_max_x_m = 0.6;
  params.fixed_min_y_m = 0;
  params.fixed_max_y_m = 0.2;
  State state = makeState(params, kCar);
  EXPECT_EQ(update(state, draw({"...."}).view(), atPlace(0, 0), params, kCar).outside, 50U);
  const layers::LayerSet set = layerSet(state, params, kCar);
  EXPECT_EQ(set.extent, (geometry::CellRect{{1, 0}, {3, 1}}));
  EXPECT_THAT(classes(set), ElementsAre("11"));
}

TEST(Update, IsExactTenThousandKilometresOut)
{
  const Params params = growing();
  const Picture scene = {".s.l.#"};
  const double far = 1e7;  // a multiple of the cell
  State state = makeState(params, kCar);
  update(state, draw(scene).view(), atPlace(far, -far), params, kCar);
  EXPECT_THAT(classes(layerSet(state, params, kCar)), ElementsAre("121314"));
}

TEST(Update, AMapWithPointsKeepsItsLattice)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  const points::ScanBuffer scan = draw({"."});
  update(state, scan.view(), atPlace(0, 0), params, kCar);
  Params other = params;
  other.cell_size_m = 0.4;
  EXPECT_THROW(update(state, scan.view(), atPlace(0, 0), other, kCar), std::invalid_argument);
  EXPECT_EQ(state.lattice.cell_mm, 200);
  State empty = makeState(params, kCar);
  EXPECT_NO_THROW(update(empty, scan.view(), atPlace(0, 0), other, kCar));
  EXPECT_EQ(empty.lattice.cell_mm, 400);
}

TEST(Update, NewLimitsClassifyOldCellsToo)
{
  Params params = growing();
  State state = makeState(params, kCar);
  update(state, draw({"s"}).view(), atPlace(0, 0), params, kCar);
  params.flat = params.small_roughness;
  EXPECT_THAT(classes(layerSet(state, params, kCar)), ElementsAre("1")) << "seen at once";
  update(state, draw({" ."}).view(), atPlace(0, 0), params, kCar);
  EXPECT_EQ(state.cells.get({0, 0})->of, Class::flat);
}

TEST(LayerSet, HasTheNamesAndCodesOfTheContract)
{
  const Params params = growing();
  State state = makeState(params, kCar);
  update(state, draw({".s.l.# 1"}).view(), atPlace(0, 0), params, kCar);
  const layers::LayerSet set = layerSet(state, params, kCar);
  std::vector<std::string> names;
  for (const layers::Layer& layer : set.layers)
  {
    names.push_back(layer.name);
  }
  EXPECT_THAT(
      names, ElementsAre(
                 "traversability_class", "traversability_index", "height_mean", "height_deviation",
                 "slope_deg", "height_variance", "point_count", "height_min", "height_max",
                 "ground_height", "last_seen_s"));
  const auto& index = std::get<std::vector<float>>(set.find("traversability_index")->data);
  EXPECT_EQ(index[0], 20);
  EXPECT_EQ(index[1], 45);
  EXPECT_EQ(index[3], 75);
  EXPECT_EQ(index[5], 100);
  EXPECT_TRUE(std::isnan(index[6])) << "never seen";
  EXPECT_TRUE(std::isnan(index[7])) << "too few points";
  EXPECT_EQ(set.legend.size(), 5U);
  const auto& last = std::get<std::vector<double>>(set.find("last_seen_s")->data);
  EXPECT_EQ(last[0], 1.6e9);
  EXPECT_TRUE(std::isnan(last[6]));
}

TEST(LayerSet, RefusesAWindowThatNoMemoryHolds)
{
  const Params params = growing();
  const State state = makeState(params, kCar);
  const geometry::CellRect huge{{-1'000'000'000, -1'000'000'000}, {1'000'000'000, 1'000'000'000}};
  EXPECT_THROW(layerSet(state, params, kCar, huge), std::length_error);
  EXPECT_EQ(layerSet(state, params, kCar).size(), 0U);
}

TEST(Params, ThatContradictThemselvesAreRefused)
{
  const auto refusal = [](auto&& change) -> std::string
  {
    Params params;
    change(params);
    try
    {
      check(params);
    }
    catch (const options::OptionError& e)
    {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal([](Params&) {}), "accepted");
  EXPECT_THAT(
      refusal([](Params& p) { p.small_roughness.slope_deg = 10; }),
      HasSubstr("small_max_slope_deg"));
  EXPECT_THAT(refusal([](Params& p) { p.index_large_roughness = 30; }), HasSubstr("index_large"));
  EXPECT_THAT(refusal([](Params& p) { p.cell_size_m = NAN; }), HasSubstr("cell_size_m"));
  EXPECT_THAT(
      refusal(
          [](Params& p)
          {
            p.extent = Extent::fixed;
            p.fixed_max_x_m = p.fixed_min_x_m;
          }),
      HasSubstr("fixed_max_x_m"));
  EXPECT_THAT(
      refusal(
          [](Params& p)
          {
            p.cell_size_m = 0.01;
            p.window_m = 2000;
          }),
      HasSubstr("window_m"));
}
}  // namespace
