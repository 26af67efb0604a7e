// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <support/grid_scenes.h>
#include <support/refusal.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::testing;
using formats::ArchiveWriter;
using formats::ByteWriter;
using formats::FormatError;
using ::testing::HasSubstr;

const geometry::Vehicle kCar;

Map sample(Extent extent)
{
  Map map;
  map.params.extent = extent;
  map.params.window_m = 12;
  map.params.index_flat = 11;
  map.vehicle.height_m = 1.7;
  map.state = makeState(map.params, map.vehicle);
  std::mt19937 random(21);
  for (int i = 0; i < 3; ++i)
  {
    update(
        map.state, randomScan(random, 400).view(), atPlace(i, -i, 0, i), map.params, map.vehicle);
  }
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

TEST(Archive, ComesBackAsTheSameMap)
{
  for (const Extent extent : {Extent::rolling, Extent::fixed, Extent::growing})
  {
    const Map map = sample(extent);
    const Map back = fromArchive(bytesOf(map));
    EXPECT_EQ(bytesOf(back), bytesOf(map));
    EXPECT_EQ(back.params, map.params);
    EXPECT_EQ(back.vehicle, map.vehicle);
    EXPECT_EQ(
        classes(layerSet(back.state, back.params, back.vehicle)),
        classes(layerSet(map.state, map.params, map.vehicle)));
  }
}

TEST(Archive, GoesOnWhereTheMapWas)
{
  Map map = sample(Extent::rolling);
  Map back = fromArchive(bytesOf(map));
  std::mt19937 random(22);
  const points::ScanBuffer scan = randomScan(random, 400);
  update(map.state, scan.view(), atPlace(5, 5), map.params, map.vehicle);
  update(back.state, scan.view(), atPlace(5, 5), back.params, back.vehicle);
  EXPECT_EQ(bytesOf(back), bytesOf(map));
}

TEST(Archive, OfAnEmptyMapIsOne)
{
  const Params params;
  const State empty = makeState(params, kCar);
  EXPECT_TRUE(fromArchive(archive(empty, params, kCar)).state.empty());
}

TEST(Archive, ANewerVersionIsRefusedByBothNumbers)
{
  ArchiveWriter writer{std::string(kArchiveKind), kArchiveVersion + 7};
  const std::string message = refusal(writer.finish());
  EXPECT_THAT(message, HasSubstr(std::to_string(kArchiveVersion + 7)));
  EXPECT_THAT(message, HasSubstr(std::to_string(kArchiveVersion)));
}

TEST(Archive, EveryTruncationIsRefused)
{
  const std::string bytes = bytesOf(sample(Extent::growing));
  for (size_t length = 0; length < bytes.size(); length += length < 400 ? 1 : 997)
  {
    ASSERT_NE(refusal(std::string_view(bytes).substr(0, length)), "accepted") << length;
  }
}

TEST(Archive, EveryFlippedBitIsRefused)
{
  std::string bytes = bytesOf(sample(Extent::growing));
  std::mt19937 random(23);
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

/** Sections of one cell with one slab of three points, to be falsified with good checksums. */
struct Forgery
{
  Params params;
  geometry::Vehicle vehicle;
  int32_t cell_mm = 200;
  int32_t slab_mm = 500;
  uint64_t cells = 1;
  int32_t x = 3;
  uint32_t slabs = 1;
  uint32_t n = 3;
  uint32_t level_n = 3;
  uint16_t low = 10;
  uint16_t high = 30;
  std::vector<int64_t> sums = {300, 300, 60, 40000, 40000, 40000, 6000, 6000, 1400, 30};
  std::vector<std::string> sensors = {"left", "right"};
  std::vector<int64_t> driven = {0, 0, -500, 20, -30, 40};
  int drives = 1;
  int copies = 1;

  std::string bytes() const
  {
    ByteWriter grid;
    grid.i32(cell_mm);
    grid.i32(slab_mm);
    grid.u8(0);
    for (int i = 0; i < 4; ++i)
    {
      grid.i32(0);
    }
    ByteWriter cell;
    cell.u64(cells);
    for (int copy = 0; copy < copies; ++copy)
    {
      cell.i32(x);
      cell.i32(0);
      cell.u32(slabs);
      cell.i32(0);
      cell.u32(n);
      cell.u16(low);
      cell.u16(high);
      cell.i64(0);
      for (const int64_t sum : sums)
      {
        cell.i64(sum);
      }
      cell.u32(1);
      cell.u32(level_n);
    }
    ByteWriter labels;
    labels.u32(static_cast<uint32_t>(sensors.size()));
    for (const std::string& label : sensors)
    {
      labels.str(label);
    }
    ByteWriter places;
    places.u64(static_cast<uint64_t>(drives));
    for (int i = 0; i < drives; ++i)
    {
      places.i32(0);
      places.i32(0);
      for (const int64_t value : driven)
      {
        places.i64(value);
      }
    }
    ArchiveWriter writer{std::string(kArchiveKind), kArchiveVersion};
    writer.section("OPTS", formats::optionBytes(params));
    writer.section("VEHI", formats::optionBytes(vehicle));
    writer.section("GRID", grid.take());
    writer.section("SENS", labels.take());
    writer.section("DRIV", places.take());
    writer.section("CELL", cell.take());
    return writer.finish();
  }
};

template <class F>
std::string forged(F&& falsify)
{
  Forgery forgery;
  forgery.params.extent = Extent::growing;
  falsify(forgery);
  return refusal(forgery.bytes());
}

TEST(Archive, ThatContradictsItselfIsRefused)
{
  EXPECT_EQ(forged([](Forgery&) {}), "accepted");
  EXPECT_THAT(forged([](Forgery& f) { f.cell_mm = 100; }), HasSubstr("another size"));
  EXPECT_THAT(forged([](Forgery& f) { f.slab_mm = 0; }), HasSubstr("another size"));
  EXPECT_NE(forged([](Forgery& f) { f.cells = 1ULL << 60U; }), "accepted");
  EXPECT_NE(forged([](Forgery& f) { f.cells = 0; }), "accepted");
  EXPECT_THAT(forged([](Forgery& f) { f.x = 2'000'000'000; }), HasSubstr("outside the map"));
  EXPECT_NE(forged([](Forgery& f) { f.slabs = 0; }), "accepted");
  EXPECT_NE(forged([](Forgery& f) { f.slabs = 4'000'000'000U; }), "accepted");
  EXPECT_THAT(forged([](Forgery& f) { f.driven[1] = -1; }), HasSubstr("driven"));
  EXPECT_THAT(forged([](Forgery& f) { f.driven[0] = -(int64_t{1} << 62U); }), HasSubstr("driven"));
  EXPECT_THAT(forged([](Forgery& f) { f.drives = 2; }), HasSubstr("twice"));
  EXPECT_THAT(forged([](Forgery& f) { f.sensors = {"b", "a"}; }), HasSubstr("order"));
  EXPECT_THAT(
      forged([](Forgery& f) { f.sensors = std::vector<std::string>(40, "a"); }),
      HasSubstr("more sensors"));
  EXPECT_THAT(forged([](Forgery& f) { f.n = 0; }), HasSubstr("no points"));
  EXPECT_THAT(forged([](Forgery& f) { f.level_n = 4; }), HasSubstr("no points"));
  EXPECT_THAT(forged([](Forgery& f) { f.low = 40; }), HasSubstr("no points"));
  EXPECT_THAT(forged([](Forgery& f) { f.high = 600; }), HasSubstr("no points"));
  for (size_t i = 0; i < 10; ++i)
  {
    for (const int64_t sum : {int64_t{-1}, int64_t{1} << 62U})
    {
      EXPECT_THAT(forged([&](Forgery& f) { f.sums[i] = sum; }), HasSubstr("no points")) << i;
    }
  }
  EXPECT_THAT(
      forged(
          [](Forgery& f)
          {
            f.cells = 2;
            f.copies = 2;
          }),
      HasSubstr("there twice"));
  EXPECT_THAT(forged([](Forgery& f) { f.params.cell_size_m = -1; }), HasSubstr("cell_size_m"));
  EXPECT_NE(forged([](Forgery& f) { f.vehicle.height_m = 1e9; }), "accepted");
}

TEST(Archive, RandomForgeriesNeverCrash)
{
  std::mt19937_64 random(24);
  int accepted = 0;
  for (int i = 0; i < 3000; ++i)
  {
    Forgery f;
    f.params.extent = static_cast<Extent>(random() % 3);
    f.x = static_cast<int32_t>(random() >> (32 + random() % 28));
    f.n = static_cast<uint32_t>(random() >> (32 + random() % 28));
    f.low = static_cast<uint16_t>(random() % 600);
    f.high = static_cast<uint16_t>(random() % 600);
    for (int64_t& sum : f.sums)
    {
      sum = static_cast<int64_t>(random() >> (random() % 60));
    }
    const std::string bytes = f.bytes();
    if (refusal(bytes) == "accepted")
    {
      ++accepted;
      const Map map = fromArchive(bytes);
      EXPECT_EQ(bytesOf(fromArchive(bytesOf(map))), bytesOf(map));
    }
  }
  EXPECT_LT(accepted, 3000);
}
}  // namespace
