// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <support/grid_scenes.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;

constexpr poses::TimeNs kSecond = 1'000'000'000;
const geometry::Vehicle kCar;

Params forgetful(double after_s, int after_points = 0)
{
  Params params;
  params.extent = Extent::growing;
  params.forget_after_s = after_s;
  params.forget_after_points = after_points;
  return params;
}

/** A map to which one picture after the other is shown, from one place, a second apart. */
class Watcher
{
 public:
  explicit Watcher(const Params& params) : params_(params), state_(makeState(params, kCar)) {}

  void see(const Picture& picture, int seconds = 1)
  {
    for (int i = 0; i < seconds; ++i)
    {
      points::ScanBuffer scan = draw(picture);
      scan.stamp = now_;
      update(state_, scan.view(), atPlace(0, 0), params_, kCar);
      now_ += kSecond;
    }
  }

  void wait(int seconds)
  {
    now_ += seconds * kSecond;
    advance(state_, now_, params_);
  }

  Class at(int32_t column) const
  {
    const Cell* cell = state_.cells.get({column, 0});
    return cell == nullptr ? Class::undefined : cell->of;
  }

  const State& state() const { return state_; }

  std::string archived() const { return archive(state_, params_, kCar); }

 private:
  Params params_;
  State state_;
  poses::TimeNs now_ = 1'600'000'000 * kSecond;
};

TEST(Forgetting, ACarThatLeftStaysInAMapThatForgetsNothing)
{
  Watcher map(forgetful(0));
  map.see({"...#.."}, 5);
  map.see({"......"}, 100);
  EXPECT_EQ(map.at(3), Class::obstacle);
}

TEST(Forgetting, ACarThatLeftGoesAfterTheAge)
{
  Watcher map(forgetful(10));
  map.see({"...#.."}, 20);
  EXPECT_EQ(map.at(3), Class::obstacle);
  map.see({"......"}, 4);
  EXPECT_EQ(map.at(3), Class::obstacle) << "less than half the age";
  map.see({"......"}, 7);
  EXPECT_EQ(map.at(3), Class::flat);
}

TEST(Forgetting, ACarThatLeftGoesAfterThatManyPoints)
{
  Watcher map(forgetful(0, 200));  // a picture has 25 in each cell
  map.see({"...#.."}, 20);
  EXPECT_EQ(map.at(3), Class::obstacle);
  map.see({"......"}, 3);
  EXPECT_EQ(map.at(3), Class::obstacle);
  map.see({"......"}, 6);
  EXPECT_EQ(map.at(3), Class::flat);
}

TEST(Forgetting, WhatIsStillSeenIsKnownAtAnyTime)
{
  Watcher map(forgetful(10, 60));
  for (int i = 0; i < 60; ++i)
  {
    map.see({"...#.."});
    ASSERT_EQ(map.at(1), Class::flat) << i;
    ASSERT_EQ(map.at(3), Class::obstacle) << i;
  }
}

TEST(Forgetting, WhatNobodySeesAnyMoreGoesBetweenTheAgeAndAnEighthMore)
{
  Watcher map(forgetful(80));
  map.see({"...#.."}, 5);
  map.wait(75);  // the last was seen 76 s ago
  EXPECT_EQ(map.at(3), Class::obstacle);
  map.wait(16);
  EXPECT_EQ(map.at(3), Class::undefined);
  EXPECT_TRUE(map.state().empty());
  EXPECT_EQ(map.state().slabs.size(), 0U) << "nothing of it is left in memory";
}

TEST(Forgetting, OneSideUnseenDoesNotTakeTheOtherAway)
{
  Watcher map(forgetful(20));
  map.see({"...#.."}, 5);
  map.see({"..    "}, 60);
  EXPECT_EQ(map.at(1), Class::flat);
  EXPECT_EQ(map.at(3), Class::undefined);
}

TEST(Forgetting, KeepsNoMoreMemoryThanTwiceWhatIsSeen)
{
  Watcher map(forgetful(4));
  map.see({"...#.."}, 10);
  const size_t early = map.state().slabs.size();
  map.see({"...#.."}, 200);
  EXPECT_LE(map.state().slabs.size(), early + 5) << "a wall 2 m high has 4 or 5 slabs";
  EXPECT_EQ(map.state().memory.due.size(), map.state().memory.next.size());
  EXPECT_EQ(map.state().memory.due.size(), 1U) << "one tile was seen";
}

TEST(Forgetting, AScanThatIsLateByMoreThanTheAgeDoesNoHarm)
{
  Watcher map(forgetful(10));
  map.see({"......"}, 30);
  map.wait(-25);
  map.see({"...#.."});
  map.wait(60);
  EXPECT_TRUE(map.state().empty());
}

TEST(Forgetting, TheRollingWindowTakesTheYoungerSumsToo)
{
  Params params = forgetful(1000);
  params.extent = Extent::rolling;
  params.window_m = 2;
  State state = makeState(params, kCar);
  for (int i = 0; i < 50; ++i)
  {
    points::ScanBuffer scan = draw({"...#.."});
    scan.stamp = i * kSecond;
    update(state, scan.view(), atPlace(0.9 * i, 0), params, kCar);
  }
  EXPECT_LT(state.slabs.size(), 200U) << "100 cells of at most 5 slabs, most of one, twice";
  EXPECT_LE(state.memory.young.tiles(), 4U);
}

TEST(Forgetting, WhatLeavesTheRollingWindowOverACornerIsForgottenWhole)
{
  Params params = forgetful(1000);
  params.extent = Extent::rolling;
  params.window_m = 20;
  State state = makeState(params, kCar);
  std::mt19937 random(1);
  points::ScanBuffer scan = randomScan(random, 2000, 12);
  for (int i = 0; i < 50; ++i)
  {
    scan.stamp = i * kSecond;
    update(state, scan.view(), atPlace(8 * std::cos(i), 8 * std::sin(i)), params, kCar);
  }
  scan = randomScan(random, 10, 0.05);
  for (const double x :
       {8, 14, 20, 26, 32, 38})  // in steps, so that the window is never left at once
  {
    scan.stamp = 50 * kSecond;
    update(state, scan.view(), atPlace(x, x), params, kCar);
  }
  EXPECT_LE(state.slabs.size(), 80U) << "ten points of each of the last four scans, twice";
  EXPECT_LE(state.memory.due.size(), 16U) << "tiles that are there";
  EXPECT_EQ(state.memory.due.size(), state.memory.next.size());
}

TEST(Forgetting, CannotBeMergedExactly)
{
  EXPECT_NE(mergeObstacle(forgetful(10)), "");
  EXPECT_NE(mergeObstacle(forgetful(0, 10)), "");
  EXPECT_EQ(mergeObstacle(forgetful(0)), "");
}
}  // namespace
