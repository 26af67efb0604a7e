// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "archive_parts.h"
#include "sensor_bits.h"

#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <limits>
#include <span>

namespace traverse::traversability_grid
{
namespace
{
using formats::ByteReader;
using formats::ByteWriter;

constexpr int64_t kMostNoise = 100'000'000;  // of one point: see ScanSource
constexpr size_t kSlabBytes = 4 + 4 + 2 + 2 + 8 + 10 * 8 + 4 + 4;
constexpr size_t kLeastCellBytes = 4 + 4 + 4 + kSlabBytes;

void writeSlab(ByteWriter& out, const layers::HeightSlab& s, std::span<const uint32_t> sensors)
{
  out.i32(s.level);
  out.u32(s.n);
  out.u16(s.min_z_mm);
  out.u16(s.max_z_mm);
  out.i64(s.last_seen);
  for (const int64_t sum : {s.x, s.y, s.z, s.xx, s.xy, s.yy, s.xz, s.yz, s.zz, s.noise})
  {
    out.i64(sum);
  }
  out.u32(renumbered(s.seen_by, sensors));
  out.u32(s.level_n);
}

layers::HeightSlab readSlab(ByteReader& in)
{
  layers::HeightSlab s;
  s.level = in.i32();
  s.n = in.u32();
  s.min_z_mm = in.u16();
  s.max_z_mm = in.u16();
  s.last_seen = in.i64();
  for (int64_t* sum : {&s.x, &s.y, &s.z, &s.xx, &s.xy, &s.yy, &s.xz, &s.yz, &s.zz, &s.noise})
  {
    *sum = in.i64();
  }
  s.seen_by = in.u32();
  s.level_n = in.u32();
  return s;
}

/** True where `sum` and `squares` can be those of n numbers in [0, most]. */
bool canBeSums(int64_t n, int64_t sum, int64_t squares, int64_t most)
{
  return sum >= 0 && sum <= n * most && squares >= 0 && squares <= sum * most;
}

bool canBeProducts(int64_t n, int64_t sum, int64_t most_a, int64_t most_b)
{
  return sum >= 0 && sum <= n * most_a * most_b;
}

/** Sums that no points can have would overflow later, or make features that are none. */
bool isPossible(const layers::HeightSlab& s, int64_t cell_mm, int64_t slab_mm)
{
  const int64_t n = s.n;
  const int64_t side = cell_mm - 1;
  const int64_t low = s.min_z_mm;
  const int64_t high = s.max_z_mm;
  return n > 0 && low <= high && high < slab_mm && s.z >= n * low && s.z <= n * high &&
         canBeSums(n, s.x, s.xx, side) && canBeSums(n, s.y, s.yy, side) &&
         canBeSums(n, s.z, s.zz, high) && canBeProducts(n, s.xy, side, side) &&
         canBeProducts(n, s.xz, side, high) && canBeProducts(n, s.yz, side, high) &&
         canBeProducts(n, s.noise, 1, kMostNoise) && s.level_n <= s.n;
}

std::string cellBytes(const State& state)
{
  const std::vector<uint32_t> sensors = archivedBits(state.sensors);
  ByteWriter out;
  out.u64(state.occupied);
  forEachOccupied(
      state,
      [&](Cells::Place place, const Cell& cell)
      {
        const geometry::CellIndex index = state.cells.indexOf(place);
        out.i32(index.x);
        out.i32(index.y);
        uint32_t count = 0;
        const layers::HeightSlab* lowest = state.slabs.get(cell.slabs);
        for (const auto* s = lowest; s != nullptr; s = state.slabs.get(s->next))
        {
          ++count;
        }
        out.u32(count);
        for (const auto* s = lowest; s != nullptr; s = state.slabs.get(s->next))
        {
          writeSlab(out, *s, sensors);
        }
      });
  return out.take();
}

std::string gridBytes(const State& state)
{
  ByteWriter out;
  out.i32(state.lattice.cell_mm);
  out.i32(state.slab_mm);
  out.u8(static_cast<uint8_t>(state.window.has_value()));
  const geometry::CellRect window = state.window.value_or(geometry::CellRect{});
  for (const int32_t edge : {window.min.x, window.min.y, window.max.x, window.max.y})
  {
    out.i32(edge);
  }
  return out.take();
}

constexpr int32_t kFarthestCell = (1 << 30) + (1 << 20);

bool isNear(geometry::CellIndex c)
{
  return c.x >= -kFarthestCell && c.x <= kFarthestCell && c.y >= -kFarthestCell &&
         c.y <= kFarthestCell;
}

void readGrid(ByteReader in, State& state)
{
  const int32_t cell_mm = in.i32();
  const int32_t slab_mm = in.i32();
  if (cell_mm != state.lattice.cell_mm || slab_mm <= 0 || slab_mm > 5000)
  {
    in.fail("cells or slabs of another size than the options say");
  }
  state.slab_mm = slab_mm;
  const uint8_t has_window = in.u8();
  geometry::CellRect window;
  for (int32_t* edge : {&window.min.x, &window.min.y, &window.max.x, &window.max.y})
  {
    *edge = in.i32();
  }
  if (has_window > 1 || !isNear(window.min) || !isNear(window.max))
  {
    in.fail("a window that is none");
  }
  if (has_window == 1)
  {
    state.window = window;
  }
  in.expectEnd();
}

void readCell(ByteReader& in, State& state, size_t most_tiles)
{
  const geometry::CellIndex index{in.i32(), in.i32()};
  const bool is_kept = !state.window || state.window->contains(index);
  const std::optional<Cells::Place> place =
      isNear(index) && is_kept ? state.cells.obtain(index, most_tiles) : std::nullopt;
  if (!place || state.cells.at(*place).slabs != layers::HeightSlabs::kNone)
  {
    in.fail("a cell that is outside the map, there twice, or beyond max_memory_mb");
  }
  const uint32_t count = in.u32();
  Cell& cell = state.cells.at(*place);
  int64_t above = std::numeric_limits<int64_t>::min();
  for (uint32_t i = 0; i < count; ++i)
  {
    const layers::HeightSlab slab = readSlab(in);
    if (slab.level <= above || !isPossible(slab, state.lattice.cell_mm, state.slab_mm))
    {
      in.fail("a height slab that no points can make");
    }
    above = slab.level;
    layers::HeightSlab* stored = state.slabs.obtain(cell.slabs, slab.level);
    if (stored == nullptr)
    {
      in.fail("more height slabs than max_memory_mb allows");
    }
    stored->add(slab);
  }
  if (count == 0)
  {
    in.fail("a cell without height slabs");
  }
  ++state.occupied;
}

void readCells(ByteReader in, State& state, const Params& params)
{
  const size_t count = in.count(kLeastCellBytes);
  const size_t most_tiles = mostTiles(params);
  for (size_t i = 0; i < count; ++i)
  {
    readCell(in, state, most_tiles);
  }
  in.expectEnd();
}
}  // namespace

std::string archive(const State& state, const Params& params, const geometry::Vehicle& vehicle)
{
  formats::ArchiveWriter writer(std::string(kArchiveKind), kArchiveVersion);
  writer.section("OPTS", formats::optionBytes(params));
  writer.section("VEHI", formats::optionBytes(vehicle));
  writer.section("GRID", gridBytes(state));
  writer.section("SENS", sensorBytes(state.sensors));
  writer.section("DRIV", drivenBytes(state.driven));
  writer.section("CELL", cellBytes(state));
  return writer.finish();
}

Map fromArchive(std::string_view bytes)
{
  const formats::ArchiveReader reader(bytes, kArchiveKind, kArchiveVersion);
  try
  {
    Map map;
    map.params = formats::readOptionBytes<Params>(reader.reader("OPTS"));
    map.vehicle = formats::readOptionBytes<geometry::Vehicle>(reader.reader("VEHI"));
    map.state = makeState(map.params, map.vehicle);
    readGrid(reader.reader("GRID"), map.state);
    readSensors(reader.reader("SENS"), map.state.sensors);
    readDriven(reader.reader("DRIV"), map.state.driven);
    readCells(reader.reader("CELL"), map.state, map.params);
    reclassify(map.state, map.params, map.vehicle);
    return map;
  }
  catch (const options::OptionError& e)
  {
    throw formats::FormatError(std::string(kArchiveKind) + " archive: " + e.what());
  }
}
}  // namespace traverse::traversability_grid
