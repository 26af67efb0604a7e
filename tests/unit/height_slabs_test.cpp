// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/layers/height_slabs.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{
using ::testing::ElementsAre;
using traverse::layers::HeightSlab;
using traverse::layers::HeightSlabs;
using traverse::layers::PointInSlab;

std::vector<int> levels(const HeightSlabs& slabs, int32_t head)
{
  std::vector<int> all;
  for (const HeightSlab* s = slabs.get(head); s != nullptr; s = slabs.get(s->next))
  {
    all.push_back(s->level);
  }
  return all;
}

TEST(HeightSlab, SumsItsPoints)
{
  HeightSlab s;
  s.add({10, 20, 30}, 5);
  s.add({1, 2, 3}, 4);
  EXPECT_EQ(s.n, 2U);
  EXPECT_EQ(s.min_z_mm, 3);
  EXPECT_EQ(s.max_z_mm, 30);
  EXPECT_EQ(s.last_seen, 5) << "the latest, not the last to come";
  EXPECT_THAT(
      (std::vector<int64_t>{s.x, s.y, s.z, s.xx, s.xy, s.yy, s.xz, s.yz, s.zz}),
      ElementsAre(11, 22, 33, 101, 202, 404, 303, 606, 909));
}

TEST(HeightSlab, AddsAnotherAsIfItsPointsHadComeHere)
{
  HeightSlab all;
  HeightSlab left;
  HeightSlab right;
  for (uint16_t i = 0; i < 10; ++i)
  {
    const PointInSlab p{i, static_cast<uint16_t>(7 * i % 10), static_cast<uint16_t>(3 * i % 10)};
    all.add(p, i);
    (i < 4 ? left : right).add(p, i);
  }
  HeightSlab sum;
  sum.add(right);
  sum.add(left);
  EXPECT_EQ(sum.n, all.n);
  EXPECT_EQ(sum.min_z_mm, all.min_z_mm);
  EXPECT_EQ(sum.max_z_mm, all.max_z_mm);
  EXPECT_EQ(sum.last_seen, all.last_seen);
  EXPECT_EQ(sum.xz, all.xz);
  EXPECT_EQ(sum.zz, all.zz);
}

TEST(HeightSlabs, AListIsSortedWhateverCameFirst)
{
  HeightSlabs slabs;
  int32_t a = HeightSlabs::kNone;
  int32_t b = HeightSlabs::kNone;
  for (const int level : {3, -2, 7, 3, 0})
  {
    slabs.obtain(a, level)->add({}, 0);
    slabs.obtain(b, -level)->add({}, 0);
  }
  EXPECT_THAT(levels(slabs, a), ElementsAre(-2, 0, 3, 7));
  EXPECT_THAT(levels(slabs, b), ElementsAre(-7, -3, 0, 2));
  EXPECT_EQ(slabs.obtain(a, 3)->n, 2U);
  EXPECT_EQ(slabs.size(), 8U);
}

TEST(HeightSlabs, ReleasedSlabsAreUsedAgainAndEmpty)
{
  HeightSlabs slabs;
  slabs.setMost(3);
  int32_t a = HeightSlabs::kNone;
  int32_t b = HeightSlabs::kNone;
  for (const int level : {1, 2, 3})
  {
    slabs.obtain(a, level)->add({1, 1, 1}, 9);
  }
  EXPECT_EQ(slabs.obtain(b, 0), nullptr) << "three are the most";
  EXPECT_EQ(b, HeightSlabs::kNone);
  slabs.release(a);
  EXPECT_EQ(a, HeightSlabs::kNone);
  EXPECT_EQ(slabs.size(), 0U);
  ASSERT_NE(slabs.obtain(b, 0), nullptr);
  EXPECT_EQ(slabs.obtain(b, 0)->n, 0U);
}

TEST(HeightSlabs, HoldsManyChunks)
{
  HeightSlabs slabs;
  std::vector<int32_t> heads(10'000, HeightSlabs::kNone);
  for (size_t i = 0; i < heads.size(); ++i)
  {
    slabs.obtain(heads[i], static_cast<int32_t>(i))->add({}, 0);
  }
  for (size_t i = 0; i < heads.size(); ++i)
  {
    ASSERT_EQ(slabs.get(heads[i])->level, static_cast<int32_t>(i));
  }
}
}  // namespace
