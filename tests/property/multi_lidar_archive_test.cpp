// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <support/occupancy_pictures.h>
#include <support/refusal.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using namespace traverse::multi_lidar_grid;
using formats::ByteWriter;
using formats::FormatError;
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

/** The sections of an archive of two cells, to be falsified with good checksums. */
struct Forgery
{
  Params params = smallMap().params;
  geometry::Vehicle vehicle;
  int32_t cell_mm = 500;
  int32_t edge = 20;
  int32_t min_x = -5;
  int64_t now = 0;
  uint8_t has_robot = 1;
  double pose_scale = 1;
  uint32_t sensors = 1;
  std::vector<std::string> labels = {"roof"};
  double period_s = 0.1;
  double offset_s = 0;
  double repeats_at_m = 0;
  int32_t x = 3;
  uint32_t run = 2;
  int copies = 1;
  uint8_t state = 2;
  uint32_t seen_by = 1;
  int64_t last_seen = 0;

  std::string gridSection() const
  {
    ByteWriter grid;
    for (const int32_t value : {cell_mm, edge, min_x, -5})
    {
      grid.i32(value);
    }
    grid.i64(now);
    grid.i64(0);
    grid.u8(has_robot);
    grid.i64(0);
    for (int i = 0; i < 12; ++i)
    {
      grid.f64(i % 5 == 0 ? pose_scale : 0);
    }
    return grid.take();
  }

  std::string sensorSection() const
  {
    ByteWriter out;
    out.u32(sensors);
    for (const std::string& label : labels)
    {
      out.str(label);
      out.i64(0);
      out.f64(period_s);
      out.u64(1);
      out.u64(0);
      out.u64(0);
      out.u32(0);
      for (int i = 0; i < 3; ++i)
      {
        out.f64(repeats_at_m);
      }
      out.f64(offset_s);
    }
    return out.take();
  }

  std::string cellSection() const
  {
    ByteWriter out;
    for (int copy = 0; copy < copies; ++copy)
    {
      out.i32(x);
      out.i32(0);
      out.u32(run);
      for (int i = 0; i < 2; ++i)
      {
        out.u8(state);
        out.u8(0);
        out.u8(0);
        out.u8(0);
        out.u8(0);
        out.u32(seen_by);
        out.i64(0);
        out.i64(last_seen);
      }
    }
    return out.take();
  }

  std::string bytes() const
  {
    formats::ArchiveWriter writer{std::string(kArchiveKind), kArchiveVersion};
    writer.section("OPTS", formats::optionBytes(params));
    writer.section("VEHI", formats::optionBytes(vehicle));
    writer.section("GRID", gridSection());
    writer.section("SENS", sensorSection());
    writer.section("CELL", cellSection());
    return writer.finish();
  }
};

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

TEST(MultiLidarArchive, AsksForNoMoreMemoryThanAMapMayHave)
{
  Forgery f;
  f.params.cell_size_m = 0.1;
  f.params.window_m = 409;
  f.sensors = 32;
  EXPECT_THAT(refusal(f.bytes()), HasSubstr("4 GB"));
}
}  // namespace
