// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <support/endless_street.h>
#include <support/resources.h>

namespace
{
using namespace traverse;
using namespace traverse::multi_lidar_grid;
using layers::OccupancyState;

constexpr double kStep_m = 5;

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** 100 km with two lidars in turns, a cloud each 5 m; the last 4 km beside a young map. */
class EndlessLidars : public ::testing::Test
{
 protected:
  EndlessLidars() : street_(kStep_m), poses_(street_.drive(104'000)) { vehicle_.height_m = 2.2; }

  State begun() const { return State(params_, vehicle_); }

  /** Returns the processor's time, s. */
  double add(State& state, size_t i)
  {
    points::Scan scan = street_.cloud(i, poses_[i]).view();
    scan.sensor_label = i % 2 == 0 ? "roof" : "wing";
    const double begin_s = traverse::testing::cpuSeconds();
    const layers::UpdateStats stats =
        update(state, scan, poses::PoseTrack::constant(poses_[i]), params_, vehicle_);
    const double took_s = traverse::testing::cpuSeconds() - begin_s;
    EXPECT_TRUE(stats.inserted) << i;
    return took_s;
  }

  size_t at(double km) const { return static_cast<size_t>(km * 1000 / kStep_m); }

  geometry::Vehicle vehicle_;
  Params params_;
  traverse::testing::EndlessStreet street_;
  std::vector<Eigen::Isometry3d> poses_;
};

bool same(const Cell& a, const Cell& b)
{
  return a.state == b.state && a.passes == b.passes && a.up_to == b.up_to &&
         a.hit_from == b.hit_from && a.belief == b.belief && a.seen_by == b.seen_by &&
         a.last_hit == b.last_hit && a.last_seen == b.last_seen;
}
}  // namespace

TEST_F(EndlessLidars, MemoryAndTimeStayFlatAndTheMapIsThatOfTheLastWindow)
{
  State old = begun();
  for (size_t i = 0; i < at(5); ++i)
  {
    add(old, i);
  }
  const double early_mb = traverse::testing::residentMb();
  for (size_t i = at(5); i < at(100); ++i)
  {
    add(old, i);
  }
  const double late_mb = traverse::testing::residentMb();
  // 100 bytes of each cloud left behind would be 1.9 MB.
  EXPECT_LT(late_mb - early_mb, 1.5);

  State young = begun();
  std::vector<double> old_s;
  std::vector<double> young_s;
  for (size_t i = at(100); i < poses_.size(); ++i)
  {
    const bool is_old_first = i % 4 < 2;
    const double before = is_old_first ? add(old, i) : add(young, i);
    const double after = is_old_first ? add(young, i) : add(old, i);
    old_s.push_back(is_old_first ? before : after);
    young_s.push_back(is_old_first ? after : before);
  }
  // Two maps that do the same work; medians of 800 clouds differ by a few percent in a busy hour.
  const double ageing = median(old_s) / median(young_s);
  EXPECT_LT(ageing, 1.15);
  std::printf(
      "resident: %.1f MB after 5 km, %.1f MB after 100 km; a cloud takes %.2f times a young "
      "map's\n",
      early_mb, late_mb, ageing);

  std::array<size_t, 5> of{};
  ASSERT_EQ(old.cells.region(), young.cells.region());
  size_t different = 0;
  old.cells.forEach(
      [&](geometry::CellIndex cell, const Cell& value)
      {
        ++of[static_cast<size_t>(value.state)];
        different += static_cast<size_t>(!same(value, young.cells.at(cell)));
      });
  EXPECT_EQ(different, 0U);
  EXPECT_GT(of[static_cast<size_t>(OccupancyState::free)], 1000U);
  EXPECT_GT(of[static_cast<size_t>(OccupancyState::obstacle)], 1000U);
}
