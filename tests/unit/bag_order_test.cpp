// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <reorder.h>
#include <transform_tree.h>

namespace
{
using namespace traverse::ros_bags;
using ::testing::ElementsAre;

constexpr int64_t kS = 1'000'000'000;

/** Stamps in the order in which they come out, of messages {stamp, recorded at}, s. */
std::vector<int64_t> reordered(const std::vector<std::pair<int64_t, int64_t>>& messages)
{
  Reorder reorder(10 * kS);
  std::vector<int64_t> out;
  const auto drain = [&]
  {
    for (auto group = reorder.takeReady(); !group.empty(); group = reorder.takeReady())
    {
      for (const Pending& pending : group)
      {
        out.push_back(pending.stamp_ns / kS);
      }
    }
  };
  for (const auto& [stamp, recorded] : messages)
  {
    Pending pending;
    pending.stamp_ns = stamp * kS;
    pending.recorded_ns = recorded * kS;
    reorder.add(std::move(pending));
    drain();
  }
  reorder.end();
  drain();
  return out;
}

TEST(Reorder, PutsStampsInOrderWithinItsWindow)
{
  EXPECT_THAT(reordered({{5, 5}, {3, 6}, {7, 7}, {4, 8}, {20, 20}}), ElementsAre(3, 4, 5, 7, 20));
}

TEST(Reorder, AStampOfAnotherClockHoldsNothingUp)
{
  EXPECT_THAT(
      reordered({{1, 1}, {9999, 2}, {3, 3}, {30, 30}, {29, 31}, {60, 60}}),
      ElementsAre(1, 9999, 3, 29, 30, 60));
}

TEST(Reorder, GivesEqualStampsTogetherInTheOrderOfRecording)
{
  Reorder reorder(kS);
  for (int64_t i = 0; i < 3; ++i)
  {
    Pending pending;
    pending.stamp_ns = i == 1 ? 0 : kS;
    pending.recorded_ns = i;
    reorder.add(std::move(pending));
  }
  reorder.end();
  EXPECT_EQ(reorder.takeReady().size(), 1U);
  const auto both = reorder.takeReady();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_LT(both[0].recorded_ns, both[1].recorded_ns);
}

Transform joint(const std::string& parent, const std::string& child, int64_t at_s, double x)
{
  Transform t;
  t.header = {at_s * kS, parent};
  t.child = child;
  t.T_parent_child.translation().x() = x;
  return t;
}

double xOf(const TransformTree& tree, const std::string& frame, int64_t at_s = 0)
{
  const auto pose = tree.find("base_link", frame, at_s * kS);
  return pose ? pose->translation().x() : -999;
}

TEST(TransformTree, JoinsFramesUpAndDown)
{
  TransformTree tree;
  tree.add(joint("base_footprint", "base_link", 0, 1), true);
  tree.add(joint("base_footprint", "mast", 0, 5), true);
  tree.add(joint("mast", "lidar", 0, 0.5), true);
  EXPECT_EQ(xOf(tree, "lidar"), 4.5);
  EXPECT_EQ(xOf(tree, "base_footprint"), -1);
  EXPECT_EQ(xOf(tree, "base_link"), 0);
  EXPECT_FALSE(tree.find("base_link", "elsewhere", 0).has_value());
  EXPECT_EQ(likelyBase(tree), "base_link");
}

TEST(TransformTree, TakesTheLatestPoseOfAMovingJoint)
{
  TransformTree tree;
  for (const int64_t at_s : {10, 30, 20})
  {
    tree.add(joint("base_link", "pan", at_s, static_cast<double>(at_s)), false);
  }
  EXPECT_EQ(xOf(tree, "pan", 5), 10) << "before its first";
  EXPECT_EQ(xOf(tree, "pan", 20), 20);
  EXPECT_EQ(xOf(tree, "pan", 29), 20);
  EXPECT_EQ(xOf(tree, "pan", 99), 30);
}

TEST(TransformTree, ARingOfFramesEnds)
{
  TransformTree tree;
  tree.add(joint("a", "b", 0, 1), true);
  tree.add(joint("b", "a", 0, 1), true);
  tree.add(joint("c", "c", 0, 1), true);
  EXPECT_FALSE(tree.find("base_link", "a", 0).has_value());
}

TEST(TransformTree, IsBounded)
{
  TransformTree tree;
  for (int i = 0; i < 10'000; ++i)
  {
    tree.add(joint("base_link", "f" + std::to_string(i), 0, 1), true);
  }
  EXPECT_TRUE(tree.full());
  EXPECT_EQ(xOf(tree, "f0"), 1);
  EXPECT_EQ(xOf(tree, "f9999"), -999);
}
}  // namespace
