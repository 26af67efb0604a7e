// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/evaluation/confusion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <support/judged_maps.h>

namespace
{
using namespace traverse;
using namespace traverse::evaluation;
using namespace traverse::testing;

TEST(Confusion, CountsCellsWithReturnsEnough)
{
  const Confusion c = confusionOf(
      mapOf(
          {"1144",  //
           ".211"},
          {"9999",  //
           "3329"}),
      truthOf(
          {"1114",  //
           "1244"}));
  EXPECT_EQ(c.cells(1, 1), 2U);
  EXPECT_EQ(c.cells(1, 4), 1U);
  EXPECT_EQ(c.cells(4, 4), 1U);
  EXPECT_EQ(c.cells(1, 0), 1U);  // undefined with three returns
  EXPECT_EQ(c.cells(2, 2), 1U);
  EXPECT_EQ(c.cells(4, 1), 1U);
  EXPECT_EQ(c.left_out, 1U);  // two returns
  EXPECT_EQ(c.total(), 7U);
}

TEST(Confusion, ComparesThePlacesNotTheRows)
{
  const Confusion c = confusionOf(
      mapOf({"12"}, {"99"}, {10, 5}),  //
      truthOf({"3312"}, {8, 5}));
  EXPECT_EQ(c.cells(1, 1), 1U);
  EXPECT_EQ(c.cells(2, 2), 1U);
  EXPECT_EQ(c.left_out, 2U);  // where the map does not reach
}

TEST(Confusion, LeavesOutWhatHasNoTruthAndWhatIsMarked)
{
  layers::LayerSet truth = truthOf({"1.11"});
  truth.layers.push_back({"truth_swept", "1", std::vector<uint8_t>{0, 0, 1, 0}});
  const Confusion c = confusionOf(mapOf({"1111"}, {"9999"}), truth);
  EXPECT_EQ(c.total(), 2U);
  EXPECT_EQ(c.left_out, 2U);
}

TEST(Confusion, ScoresAreThoseByHand)
{
  const ClassScores s = scoresOf(confusionOf(
      mapOf({"1144.", "44411"}, {"99999", "99999"}),  //
      truthOf({"11111", "44444"})));
  // flat: 5 in truth, 4 found, 2 right; obstacle: 5, 5, 3
  EXPECT_EQ(s.classes[0].name, "flat");
  EXPECT_DOUBLE_EQ(s.classes[0].recall, 2.0 / 5);
  EXPECT_DOUBLE_EQ(s.classes[0].precision, 2.0 / 4);
  EXPECT_DOUBLE_EQ(s.classes[0].f1, 4.0 / 9);
  EXPECT_DOUBLE_EQ(s.classes[0].iou, 2.0 / 7);
  EXPECT_DOUBLE_EQ(s.classes[3].recall, 3.0 / 5);
  EXPECT_DOUBLE_EQ(s.classes[3].iou, 3.0 / 7);
  EXPECT_DOUBLE_EQ(s.mean_accuracy, 0.5);  // of the two that are there
  EXPECT_DOUBLE_EQ(s.accuracy, 0.5);
  EXPECT_TRUE(std::isnan(s.classes[1].recall));
  EXPECT_TRUE(std::isnan(s.classes[1].precision));
  EXPECT_TRUE(std::isnan(s.classes[1].f1));
}

TEST(Confusion, NothingComparedHasNoScore)
{
  const ClassScores s = scoresOf(confusionOf(mapOf({"."}, {"."}), truthOf({"1"})));
  EXPECT_TRUE(std::isnan(s.mean_accuracy));
  EXPECT_TRUE(std::isnan(s.accuracy));
  EXPECT_TRUE(scoresOf(Confusion{}).classes.empty());
}

TEST(Confusion, AllOfOneClassIsRight)
{
  const ClassScores s = scoresOf(confusionOf(mapOf({"44"}, {"33"}), truthOf({"44"})));
  EXPECT_DOUBLE_EQ(s.mean_accuracy, 1);
  EXPECT_DOUBLE_EQ(s.classes[3].iou, 1);
}

TEST(Confusion, CountsOfRunsAddUp)
{
  Confusion sum;
  const Confusion one = confusionOf(mapOf({"14"}, {"91"}), truthOf({"14"}));
  sum += one;
  sum += one;
  EXPECT_EQ(sum.cells(1, 1), 2U);
  EXPECT_EQ(sum.left_out, 2U);
  EXPECT_THROW(sum += Confusion({"undefined", "other"}), std::invalid_argument);
}

TEST(Confusion, RefusesWhatCannotBeCompared)
{
  const layers::LayerSet map = mapOf({"1"}, {"9"});
  EXPECT_THROW(confusionOf(map, drawnClasses({"1"})), std::invalid_argument);  // no truth layer
  EXPECT_THROW(confusionOf(drawnClasses({"1"}), truthOf({"1"})), std::invalid_argument);
  layers::LayerSet coarse = truthOf({"1"});
  coarse.lattice.cell_mm = 400;
  EXPECT_THROW(confusionOf(map, coarse), std::invalid_argument);
  EXPECT_THROW(confusionOf(mapOf({"9"}, {"9"}), truthOf({"1"})), std::out_of_range);
  EXPECT_THROW(Confusion({"undefined", "a"}).add(0, 1), std::out_of_range);
}
}  // namespace
