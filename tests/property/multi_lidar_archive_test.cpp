// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/archive.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <support/forged_multi_lidar_map.h>
#include <support/occupancy_pictures.h>
#include <support/refusal.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using namespace traverse::multi_lidar_grid;
using ::testing::AllOf;
using ::testing::HasSubstr;

/** Random cells around a far place, seen by two sensors. */
Map sample()
{
  Map map = smallMap();
  map.params.sensor_labels = "left right";
  map.params.sensor_timeouts_s = {0.3, 0.4};
  map.state.cells.moveTo({-1000, 70'000});
  addCloud(map, "left", {"."});
  addCloud(map, "right", {"."}, 3);
  map.state.sensors.all().front().period_s = 0.1;
  map.state.sensors.all().back().clock_offset_s = 0.08;
  map.state.sensors.all().back().refused = 4;
  std::mt19937 random(31);
  map.state.cells.forEach(
      [&](geometry::CellIndex, Cell& cell)
      {
        if (random() % 3 == 0)
        {
          cell.state = static_cast<layers::OccupancyState>(random() % 5);
          cell.passes = static_cast<uint8_t>(random());
          cell.up_to = static_cast<uint8_t>(random());
          cell.belief = static_cast<int8_t>(random());
          cell.seen_by = random() % 4;
          cell.last_seen = static_cast<poses::TimeNs>(random());
          cell.last_hit = -static_cast<poses::TimeNs>(random());
        }
      });
  return map;
}

std::string bytesOf(const Map& map)
{
  return archive(map.state, map.params, map.vehicle);
}

std::string refusal(std::string_view bytes)
{
  return refusalOf([&] { fromArchive(bytes); });
}

TEST(MultiLidarArchive, ComesBackAsTheSameMap)
{
  const Map map = sample();
  const Map back = fromArchive(bytesOf(map));
  EXPECT_EQ(bytesOf(back), bytesOf(map));
  EXPECT_EQ(back.params, map.params);
  EXPECT_EQ(back.vehicle, map.vehicle);
  EXPECT_EQ(back.state.now, map.state.now);
  EXPECT_EQ(back.state.cells.region(), map.state.cells.region());
  ASSERT_EQ(back.state.sensors.all().size(), 2U);
  const Sensor& right = back.state.sensors.all().back();
  EXPECT_EQ(right.label, "right");
  EXPECT_EQ(right.clock_offset_s, 0.08);
  EXPECT_EQ(right.refused, 4U);
  EXPECT_FALSE(right.has_cloud) << "the latest clouds are gone with their time";
  EXPECT_EQ(
      layersOf(back).find("occupancy_state")->data, layersOf(map).find("occupancy_state")->data);
}

TEST(MultiLidarArchive, OfAnEmptyMapIsOne)
{
  Map map = smallMap();
  map.state.robot.reset();
  EXPECT_TRUE(fromArchive(bytesOf(map)).state.empty());
}

TEST(MultiLidarArchive, HoldsKnownCellsOnly)
{
  Map map = smallMap();
  const size_t empty = bytesOf(map).size();
  map.state.cells.at({1, 1}).state = layers::OccupancyState::free;
  const size_t one = bytesOf(map).size();
  map.state.cells.at({2, 1}).state = layers::OccupancyState::free;
  EXPECT_LT(one - empty, 40U);
  EXPECT_EQ(bytesOf(map).size() - one, 25U) << "a run's second cell needs no place of its own";
}

TEST(MultiLidarArchive, OfANewerVersionIsRefusedByBothNumbers)
{
  formats::ArchiveWriter writer{std::string(kArchiveKind), kArchiveVersion + 7};
  EXPECT_THAT(
      refusal(writer.finish()), AllOf(
                                    HasSubstr(std::to_string(kArchiveVersion + 7)),
                                    HasSubstr(std::to_string(kArchiveVersion))));
}

TEST(MultiLidarArchive, EverySeventhTruncationIsRefused)
{
  const std::string bytes = bytesOf(sample());
  for (size_t length = 0; length < bytes.size(); length += 7)
  {
    ASSERT_NE(refusal(std::string_view(bytes).substr(0, length)), "accepted") << length;
  }
}

TEST(MultiLidarArchive, EveryFlippedBitIsRefused)
{
  std::string bytes = bytesOf(sample());
  std::mt19937 random(32);
  for (int i = 0; i < 2000; ++i)
  {
    const size_t at = i < 600 ? static_cast<size_t>(i) : random() % bytes.size();
    const char flip = static_cast<char>(1U << (random() % 8));
    bytes[at] = static_cast<char>(bytes[at] ^ flip);
    ASSERT_NE(refusal(bytes), "accepted") << at;
    bytes[at] = static_cast<char>(bytes[at] ^ flip);
  }
  EXPECT_EQ(refusal(bytes), "accepted");
}

template <class F>
std::string forged(F&& falsify)
{
  Forgery forgery;
  falsify(forgery);
  return refusal(forgery.bytes());
}

TEST(MultiLidarArchive, ThatContradictsItselfIsRefused)
{
  EXPECT_EQ(forged([](Forgery&) {}), "accepted");
  EXPECT_THAT(forged([](Forgery& f) { f.cell_mm = 100; }), HasSubstr("another size"));
  EXPECT_THAT(forged([](Forgery& f) { f.edge = 19; }), HasSubstr("another size"));
  EXPECT_THAT(forged([](Forgery& f) { f.min_x = -2'000'000'000; }), HasSubstr("too far out"));
  EXPECT_THAT(forged([](Forgery& f) { f.now = int64_t{1} << 62U; }), HasSubstr("time"));
  EXPECT_THAT(forged([](Forgery& f) { f.has_robot = 2; }), HasSubstr("robot"));
  EXPECT_THAT(forged([](Forgery& f) { f.pose_scale = 2; }), HasSubstr("pose"));
  EXPECT_THAT(forged([](Forgery& f) { f.pose_scale = std::nan(""); }), HasSubstr("pose"));
  EXPECT_NE(forged([](Forgery& f) { f.sensors = 2; }), "accepted");
  EXPECT_THAT(forged([](Forgery& f) { f.sensors = 33; }), HasSubstr("more sensors"));
  EXPECT_THAT(
      forged(
          [](Forgery& f)
          {
            f.sensors = 2;
            f.labels = {"roof", "roof"};
          }),
      HasSubstr("there twice"));
  EXPECT_THAT(forged([](Forgery& f) { f.period_s = -1; }), HasSubstr("range"));
  EXPECT_THAT(forged([](Forgery& f) { f.offset_s = std::nan(""); }), HasSubstr("range"));
  EXPECT_THAT(forged([](Forgery& f) { f.repeats_at_m = 1e300; }), HasSubstr("range"));
  EXPECT_THAT(forged([](Forgery& f) { f.x = 14; }), HasSubstr("outside the region"));
  EXPECT_THAT(forged([](Forgery& f) { f.x = -2'000'000'000; }), HasSubstr("outside the region"));
  EXPECT_THAT(forged([](Forgery& f) { f.run = 0; }), HasSubstr("run"));
  EXPECT_THAT(forged([](Forgery& f) { f.run = 4'000'000'000U; }), HasSubstr("run"));
  EXPECT_NE(forged([](Forgery& f) { f.run = 1; }), "accepted");
  EXPECT_THAT(forged([](Forgery& f) { f.copies = 2; }), HasSubstr("out of order"));
  EXPECT_THAT(forged([](Forgery& f) { f.state = 5; }), HasSubstr("state"));
  EXPECT_THAT(forged([](Forgery& f) { f.seen_by = 2; }), HasSubstr("sensor that is not there"));
  EXPECT_THAT(forged([](Forgery& f) { f.last_seen = -(int64_t{1} << 62U); }), HasSubstr("time"));
  EXPECT_THAT(forged([](Forgery& f) { f.params.cell_size_m = -1; }), HasSubstr("cell_size_m"));
  EXPECT_THAT(forged([](Forgery& f) { f.vehicle.height_m = 0.1; }), HasSubstr("height"));
}

points::ScanBuffer oneReturn()
{
  points::ScanBuffer scan;
  scan.sensor_label = "roof";
  scan.T_base_sensor.translation().z() = 1.8;
  scan.x = {2};
  scan.y = {0.5};
  scan.z = {1};
  return scan;
}

/** What is accepted is a map like another: it can be shown, goes on, and is the same again. */
TEST(MultiLidarArchive, RandomForgeriesNeverCrash)
{
  std::mt19937_64 random(33);
  const auto any = [&random](uint64_t below) { return random() % below; };
  const poses::PoseTrack here = poses::PoseTrack::constant(Eigen::Isometry3d::Identity());
  int accepted = 0;
  for (int i = 0; i < 3000; ++i)
  {
    Forgery f;
    f.min_x = static_cast<int32_t>(random()) >> any(32);
    f.x = static_cast<int32_t>(int64_t{f.min_x} + static_cast<int64_t>(any(24)) - 2);
    f.run = static_cast<uint32_t>(any(8) == 0 ? random() : 2);
    f.has_robot = static_cast<uint8_t>(any(3));
    f.now = static_cast<int64_t>(random()) >> any(60);
    f.last_seen = static_cast<int64_t>(random()) >> any(60);
    f.state = static_cast<uint8_t>(any(6));
    f.seen_by = static_cast<uint32_t>(any(3));
    f.offset_s = static_cast<double>(any(4000)) - 300;
    f.repeats_at_m = static_cast<double>(random() >> (36 + any(28)));
    const std::string bytes = f.bytes();
    if (refusal(bytes) != "accepted")
    {
      continue;
    }
    ++accepted;
    Map map = fromArchive(bytes);
    EXPECT_EQ(bytesOf(fromArchive(bytesOf(map))), bytesOf(map));
    EXPECT_EQ(layersOf(map).size(), map.state.empty() ? 0U : 400U);
    update(map.state, oneReturn().view(), here, map.params, map.vehicle);
    explain(map.state, map.params, map.vehicle, {0, 0});
  }
  EXPECT_GT(accepted, 100);
  EXPECT_LT(accepted, 2000);
}

TEST(MultiLidarArchive, AsksForNoMoreMemoryThanAMapMayHave)
{
  Forgery f;
  f.params.cell_size_m = 0.1;
  f.params.window_m = 409;
  f.sensors = 32;
  EXPECT_THAT(refusal(f.bytes()), HasSubstr("4 GB"));
}
}  // namespace
