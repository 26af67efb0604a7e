// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/ghosts.h>
#include <traverse/evaluation/obstacles.h>
#include <traverse/evaluation/outlines.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <support/judged_maps.h>

namespace
{
using namespace traverse;
using namespace traverse::evaluation;
using namespace traverse::testing;

/** All cells with nine returns. */
Drawn many(const Drawn& drawn)
{
  return Drawn(drawn.size(), std::string(drawn[0].size(), '9'));
}

TEST(ObstacleScore, CountsCellsThingsAndPhantoms)
{
  const Drawn classes = {"1111144", "1441111", "1441141"};
  layers::LayerSet truth = truthOf({"1111111", "1441141", "1441111"});
  addDrawnNumbers(truth, "truth_object", {"1111111", "1231151", "1231111"});
  const ObstacleScore score = obstacleScore(mapOf(classes, many(classes)), truth);
  EXPECT_EQ(score.true_cells, 5U);
  EXPECT_EQ(score.found_cells, 4U);
  EXPECT_EQ(score.objects, 3U);
  EXPECT_EQ(score.found_objects, 2U);
  EXPECT_EQ(score.missed, std::vector<uint32_t>{5});
  EXPECT_EQ(score.map_cells, 7U);
  EXPECT_EQ(score.phantom_cells, 0U);  // all others touch a true one
  EXPECT_DOUBLE_EQ(score.cellRecall(), 0.8);
}

TEST(ObstacleScore, PhantomsAreFartherThanACell)
{
  const Drawn classes = {"1411"};
  layers::LayerSet truth = truthOf({"1114"});
  addDrawnNumbers(truth, "truth_object", {"1112"});
  const ObstacleScore score = obstacleScore(mapOf(classes, many(classes)), truth);
  EXPECT_EQ(score.phantom_cells, 1U);
  EXPECT_DOUBLE_EQ(score.phantomShare(), 1);
  EXPECT_DOUBLE_EQ(score.objectRecall(), 0);
}

TEST(ObstacleScore, NothingThereHasNoScore)
{
  layers::LayerSet truth = truthOf({"11"});
  addDrawnNumbers(truth, "truth_object", {"11"});
  const ObstacleScore score = obstacleScore(mapOf({"11"}, {"99"}), truth);
  EXPECT_TRUE(std::isnan(score.cellRecall()));
  EXPECT_TRUE(std::isnan(score.objectRecall()));
  EXPECT_TRUE(std::isnan(score.phantomShare()));
}

TEST(StateAgreement, CountsWhatTheMapKnows)
{
  layers::LayerSet truth = truthOf({"1114.4"});
  addDrawn(truth, "truth_state", {"1132.4"});
  const StateAgreement s = stateAgreement(mapOf({"12.411"}, {"999999"}), truth);
  EXPECT_DOUBLE_EQ(s.freeAgreement(), 1);        // two of two; one is unknown
  EXPECT_DOUBLE_EQ(s.occupiedAgreement(), 0.5);  // the ditch is not
  EXPECT_DOUBLE_EQ(s.knownShare(), 4.0 / 5);
  EXPECT_EQ(s.cells[3][0], 1U);
}

TEST(StateAgreement, OfNothingKnownIsNaN)
{
  layers::LayerSet truth = truthOf({"1"});
  addDrawn(truth, "truth_state", {"1"});
  const StateAgreement s = stateAgreement(mapOf({"."}, {"."}), truth);
  EXPECT_TRUE(std::isnan(s.freeAgreement()));
  EXPECT_TRUE(std::isnan(s.occupiedAgreement()));
  EXPECT_DOUBLE_EQ(s.knownShare(), 0);
}

Polygon rectangle(double x0, double y0, double x1, double y1)
{
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(Outlines, ExactCellsHaveNoError)
{
  const OutlineScores s = outlineScores(
      drawnClasses({"1111", "1441", "1441", "1111"}), {{7, {rectangle(0.2, 0.2, 0.6, 0.6)}}});
  ASSERT_EQ(s.things.size(), 1U);
  EXPECT_EQ(s.things[0].object, 7U);
  EXPECT_NEAR(s.things[0].true_area_m2, 0.16, 1e-12);
  EXPECT_NEAR(s.things[0].found_area_m2, 0.16, 1e-12);
  EXPECT_NEAR(s.things[0].area_error_m2, 0, 1e-12);
  EXPECT_NEAR(s.things[0].hausdorff_m, 0, 1e-12);
  EXPECT_EQ(s.clusters, 1U);
  EXPECT_EQ(s.foreign_clusters, 0U);
}

TEST(Outlines, OneSideOfAThingLacksTheRest)
{
  // the left one of four columns was seen
  const OutlineScores s =
      outlineScores(drawnClasses({"411111", "411111"}), {{2, {rectangle(0, 0, 0.8, 0.4)}}});
  ASSERT_EQ(s.things.size(), 1U);
  EXPECT_NEAR(s.things[0].area_error_m2, 6 * 0.04, 1e-12);
  EXPECT_NEAR(s.things[0].hausdorff_m, 0.6, 1e-12);
}

TEST(Outlines, CellsOutsideCount)
{
  const OutlineScores s =
      outlineScores(drawnClasses({"444441"}), {{2, {rectangle(0, 0, 0.4, 0.2)}}});
  ASSERT_EQ(s.things.size(), 1U);
  EXPECT_NEAR(s.things[0].area_error_m2, 3 * 0.04, 1e-12);
  EXPECT_NEAR(s.things[0].hausdorff_m, 0.5, 1e-12);  // middle of the last cell
}

TEST(Outlines, ClustersFarFromThingsAreForeign)
{
  const OutlineScores s = outlineScores(
      drawnClasses({"4111114"}), {{2, {rectangle(0, 0, 0.2, 0.2)}}, {3, {rectangle(5, 5, 6, 6)}}});
  EXPECT_EQ(s.clusters, 2U);
  EXPECT_EQ(s.foreign_clusters, 1U);
  EXPECT_EQ(s.not_found, std::vector<uint32_t>{3});
}

TEST(Outlines, EachCellBelongsToTheNearestOfTwoThings)
{
  const OutlineScores s = outlineScores(
      drawnClasses({"444444"}),
      {{2, {rectangle(0, 0, 0.4, 0.2)}}, {3, {rectangle(0.6, 0, 1.2, 0.2)}}});
  ASSERT_EQ(s.things.size(), 2U);
  EXPECT_NEAR(s.things[0].found_area_m2 + s.things[1].found_area_m2, 6 * 0.04, 1e-12);
  EXPECT_NEAR(s.things[1].area_error_m2 + s.things[0].area_error_m2, 0.04, 1e-12);
}

TEST(Outlines, HugeThingsAreMeasuredNotCounted)
{
  const OutlineScores s = outlineScores(drawnClasses({"44"}), {{2, {rectangle(0, 0, 1e7, 0.2)}}});
  ASSERT_EQ(s.things.size(), 1U);
  EXPECT_NEAR(s.things[0].area_error_m2, 2e6 - 0.08, 1);
}

TEST(Outlines, TakeBoundedTime)
{
  Polygon detailed;
  constexpr int kCorners = 200000;
  detailed.reserve(2 * kCorners);
  for (int i = 0; i < kCorners; ++i)
  {
    detailed.emplace_back(i * 1e-3, 0);
  }
  for (int i = kCorners; i > 0; --i)
  {
    detailed.emplace_back(i * 1e-3, 20);
  }
  EXPECT_THROW(
      outlineScores(drawnClasses(Drawn(50, std::string(50, '4'))), {{2, {detailed}}}),
      std::length_error);
  Polygon far(2000, {0, 0});  // to a far place and back, again and again
  for (size_t i = 0; i < far.size(); i += 2)
  {
    far[i] = {1e7, static_cast<double>(i)};
  }
  far.emplace_back(0, 1e4);
  EXPECT_THROW(
      outlineScores(drawnClasses(Drawn(50, std::string(50, '4'))), {{2, {far}}}),
      std::length_error);
}

TEST(Outlines, OfNoAreaAreNoThings)
{
  const OutlineScores s = outlineScores(
      drawnClasses({"4"}), {{2, {Polygon(3, {0.1, 0.1})}}, {3, {rectangle(0, 0, 5, 0)}}});
  EXPECT_TRUE(s.things.empty());
  EXPECT_TRUE(s.not_found.empty());
  EXPECT_EQ(s.foreign_clusters, 1U);
}

TEST(Outlines, NothingGivesNothing)
{
  EXPECT_TRUE(outlineScores(drawnClasses({"11"}), {}).things.empty());
  const OutlineScores s =
      outlineScores(drawnClasses({"11"}), {{2, {rectangle(0, 0, 1, 1)}}, {3, {}}});
  EXPECT_EQ(s.not_found, std::vector<uint32_t>{2});
  EXPECT_THROW(outlineScores({}, {}), std::invalid_argument);  // no class layer
}

TEST(Ghosts, LastUntilTheCellIsClear)
{
  const geometry::CellIndex a{1, 1};
  const geometry::CellIndex b{2, 1};
  const std::vector<ObstacleFrame> frames = {{0, {a, b}}, {1, {a, b}}, {2, {b}}, {3, {b}}};
  const GhostScore s =
      ghostScore(frames, {{a, 0.5}, {b, 0.5}, {{9, 9}, 0.5}, {a, 3.5}, {b, 0.5, 2.5}});
  EXPECT_EQ(s.seconds, (std::vector<double>{0, 1.5, 1.5, 2.5}));
  EXPECT_EQ(s.never_cleared, 2U);
  EXPECT_EQ(s.unseen, 1U);
  EXPECT_DOUBLE_EQ(s.mean_s(), 5.5 / 4);
  EXPECT_DOUBLE_EQ(s.percentile_s(0.5), 1.5);
  EXPECT_DOUBLE_EQ(s.percentile_s(1), 2.5);
}

TEST(Ghosts, OfNothingHaveNoTime)
{
  EXPECT_TRUE(std::isnan(ghostScore({}, {}).mean_s()));
  EXPECT_TRUE(std::isnan(ghostScore({}, {{{0, 0}, 1}}).percentile_s(0.9)));
  EXPECT_THROW(ghostScore({{1, {}}, {0, {}}}, {}), std::invalid_argument);
}
}  // namespace
