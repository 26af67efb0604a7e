// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/occupancy_score.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <support/judged_maps.h>

namespace
{
using namespace traverse;
using namespace traverse::evaluation;
using namespace traverse::testing;

/** A map: 0 unknown, 1 free, 2 obstacle, 3 negative, 4 overhang. */
layers::LayerSet occupancyOf(const Drawn& states)
{
  layers::LayerSet map = drawnClasses(states);
  map.layers[0].name = map.class_layer = "occupancy_state";
  return map;
}

/** A truth: 0 unknown, 1 free, 2 occupied, 3 overhang, 4 ditch. */
layers::LayerSet statesOf(const Drawn& states)
{
  layers::LayerSet truth = drawnClasses(states);
  truth.layers[0].name = truth.class_layer = "truth_state";
  return truth;
}

OccupancyParams strict()
{
  OccupancyParams params;
  params.tolerance_cells = 0;
  return params;
}

TEST(OccupancyScore, ATrueMapIsRight)
{
  const OccupancyScore score = occupancyScore(
      occupancyOf({"1211", "1143", "1111"}), statesOf({"1211", "1134", "1111"}), strict());
  EXPECT_DOUBLE_EQ(score.obstacleRecall(), 1);
  EXPECT_DOUBLE_EQ(score.falseObstacleRate(), 0);
  EXPECT_DOUBLE_EQ(score.freeIou(), 1);
  EXPECT_DOUBLE_EQ(score.ditchRecall(), 1);
  EXPECT_DOUBLE_EQ(score.blindShare(), 0);
  EXPECT_EQ(score.known_free, 10U);
}

TEST(OccupancyScore, ANeighbourIsForgivenWithinTheToleranceOnly)
{
  const layers::LayerSet truth = statesOf({"11111", "12111", "11111"});
  const layers::LayerSet map = occupancyOf({"11111", "11211", "11111"});
  const OccupancyScore plain = occupancyScore(map, truth);
  EXPECT_EQ(plain.found_obstacles, 1U);
  EXPECT_EQ(plain.false_obstacles, 0U);
  EXPECT_DOUBLE_EQ(plain.freeIou(), 1);
  const OccupancyScore exact = occupancyScore(map, truth, strict());
  EXPECT_EQ(exact.found_obstacles, 0U);
  EXPECT_EQ(exact.false_obstacles, 1U);
  EXPECT_DOUBLE_EQ(exact.freeIou(), 13.0 / 15);  // both: 13; either: all
  const OccupancyScore far = occupancyScore(occupancyOf({"11111", "11121", "11111"}), truth);
  EXPECT_EQ(far.found_obstacles, 0U);
  EXPECT_EQ(far.false_obstacles, 1U);
}

TEST(OccupancyScore, ObstaclesNeedReturns)
{
  layers::LayerSet truth = statesOf({"2121"});
  addDrawnNumbers(truth, "returns", {"1929"});
  const OccupancyScore score = occupancyScore(occupancyOf({"1111"}), truth);
  EXPECT_EQ(score.obstacles, 1U);
  EXPECT_DOUBLE_EQ(score.obstacleRecall(), 0);
}

TEST(OccupancyScore, WithoutReturnsWhatTheMapKnowsIsJudged)
{
  const OccupancyScore score = occupancyScore(occupancyOf({"0112"}), statesOf({"2122"}), strict());
  EXPECT_EQ(score.obstacles, 2U);
  EXPECT_EQ(score.found_obstacles, 1U);
  layers::LayerSet moved = statesOf({"2122"});
  addDrawn(moved, "truth_swept", {"0010"});  // something came there, and hides its inside
  EXPECT_EQ(occupancyScore(occupancyOf({"0112"}), moved, strict()).obstacles, 1U);
}

TEST(OccupancyScore, NothingIsFalseWhereSomethingMoved)
{
  layers::LayerSet truth = statesOf({"111111"});
  addDrawn(truth, "truth_swept", {"100000"});
  const layers::LayerSet map = occupancyOf({"222111"});
  EXPECT_EQ(occupancyScore(map, truth, strict()).false_obstacles, 2U);
  EXPECT_EQ(occupancyScore(map, truth).false_obstacles, 1U);  // the neighbour is forgiven
}

TEST(OccupancyScore, DitchesTakenForFreeAreCounted)
{
  const OccupancyScore score =
      occupancyScore(occupancyOf({"312031"}), statesOf({"444441"}), strict());
  EXPECT_EQ(score.ditches, 5U);
  EXPECT_EQ(score.found_ditches, 2U);
  EXPECT_EQ(score.ditches_as_free, 1U);
  EXPECT_DOUBLE_EQ(score.ditchAsFreeRate(), 0.2);
  EXPECT_EQ(occupancyScore(occupancyOf({"1113"}), statesOf({"1111"})).false_ditches, 1U);
}

TEST(OccupancyScore, BlindAreaIsOfFreeCells)
{
  const OccupancyScore score = occupancyScore(occupancyOf({"0101"}), statesOf({"1132"}));
  EXPECT_EQ(score.free_cells, 3U);
  EXPECT_EQ(score.unknown_free, 2U);
}

TEST(OccupancyScore, JudgesACircle)
{
  OccupancyParams params = strict();
  params.centre_x_m = params.centre_y_m = 0.1;  // the first cell's middle
  params.radius_m = 0.45;                       // two cells of 0.2 m on
  const OccupancyScore score = occupancyScore(occupancyOf({"22222"}), statesOf({"11111"}), params);
  EXPECT_EQ(score.false_obstacles, 3U);
  params.ditch_radius_m = 0.25;
  EXPECT_EQ(occupancyScore(occupancyOf({"33333"}), statesOf({"44444"}), params).ditches, 2U);
}

TEST(OccupancyScore, AddsUp)
{
  OccupancyScore sum;
  sum += occupancyScore(occupancyOf({"22"}), statesOf({"21"}), strict());
  sum += occupancyScore(occupancyOf({"11"}), statesOf({"21"}), strict());
  EXPECT_DOUBLE_EQ(sum.obstacleRecall(), 0.5);
  EXPECT_DOUBLE_EQ(sum.falseObstacleRate(), 0.5);
}

TEST(OccupancyScore, NothingHasNoScore)
{
  const OccupancyScore score = occupancyScore(occupancyOf({"00"}), statesOf({"00"}));
  EXPECT_TRUE(std::isnan(score.obstacleRecall()));
  EXPECT_TRUE(std::isnan(score.freeIou()));
  EXPECT_TRUE(std::isnan(score.blindShare()));
}

TEST(OccupancyScore, OutsideTheMapNothingIsKnown)
{
  const OccupancyScore score = occupancyScore(occupancyOf({"1"}), statesOf({"1111"}));
  EXPECT_EQ(score.unknown_free, 3U);
}

TEST(OccupancyScore, RefusesMissingLayersAndOtherCells)
{
  layers::LayerSet map = occupancyOf({"1"});
  EXPECT_THROW(occupancyScore(map, occupancyOf({"1"})), std::invalid_argument);
  map.lattice.cell_mm = 100;
  EXPECT_THROW(occupancyScore(map, statesOf({"1"})), std::invalid_argument);
}
}  // namespace
