// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "archive_parts.h"

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr size_t kCellBytes = 4 + 4 + 8 + 8;

bool isEmptyCell(const Cell& c)
{
  return c.state == layers::OccupancyState::unknown && c.passes == 0 && c.up_to == 0 &&
         c.hit_from == 0 && c.belief == 0 && c.seen_by == 0 && c.last_hit == 0 && c.last_seen == 0;
}

/** Cells of a row that follow each other, none of them empty. */
struct Run
{
  geometry::CellIndex first;
  uint32_t length = 0;
  formats::ByteWriter cells;
};

void writeCell(formats::ByteWriter& out, const Cell& cell)
{
  out.u8(static_cast<uint8_t>(cell.state));
  out.u8(cell.passes);
  out.u8(cell.up_to);
  out.u8(cell.hit_from);
  out.u8(static_cast<uint8_t>(cell.belief));
  out.u32(cell.seen_by);
  out.i64(cell.last_hit);
  out.i64(cell.last_seen);
}

Cell readCell(formats::ByteReader& in, uint32_t known_sensors)
{
  Cell cell;
  const uint8_t state = in.u8();
  if (state > static_cast<uint8_t>(layers::OccupancyState::overhang))
  {
    in.fail("a cell of a state that is none");
  }
  cell.state = static_cast<layers::OccupancyState>(state);
  cell.passes = in.u8();
  cell.up_to = in.u8();
  cell.hit_from = in.u8();
  cell.belief = static_cast<int8_t>(in.u8());
  cell.seen_by = in.u32();
  if ((cell.seen_by & ~known_sensors) != 0)
  {
    in.fail("a cell that was seen by a sensor that is not there");
  }
  cell.last_hit = readTime(in);
  cell.last_seen = readTime(in);
  return cell;
}

void finish(Run& run, formats::ByteWriter& out)
{
  if (run.length > 0)
  {
    out.i32(run.first.x);
    out.i32(run.first.y);
    out.u32(run.length);
    out.raw(run.cells.take());
  }
  run = {};
}

bool follows(geometry::CellIndex cell, geometry::CellIndex before)
{
  return cell.y > before.y || (cell.y == before.y && cell.x > before.x);
}
}  // namespace

std::string cellBytes(const layers::WrappedGrid<Cell>& cells)
{
  formats::ByteWriter out;
  Run run;
  cells.forEach(
      [&](geometry::CellIndex c, const Cell& cell)
      {
        const bool goes_on = run.length > 0 && c.y == run.first.y &&
                             c.x - run.first.x == static_cast<int32_t>(run.length);
        if (isEmptyCell(cell) || !goes_on)
        {
          finish(run, out);
          run.first = c;
        }
        if (!isEmptyCell(cell))
        {
          writeCell(run.cells, cell);
          ++run.length;
        }
      });
  finish(run, out);
  return out.take();
}

void readCells(formats::ByteReader in, State& state)
{
  const geometry::CellRect& region = state.cells.region();
  const size_t sensors = state.sensors.all().size();
  const auto known = static_cast<uint32_t>((uint64_t{1} << sensors) - 1);
  geometry::CellIndex last{region.min.x - 1, region.min.y};
  while (in.remaining() > 0)
  {
    geometry::CellIndex cell{in.i32(), in.i32()};
    const uint32_t length = in.u32();
    if (length == 0 || length > in.remaining() / kCellBytes)
    {
      in.fail("a run of more cells than there are, or of none");
    }
    for (uint32_t i = 0; i < length; ++i, ++cell.x)
    {
      if (!region.contains(cell) || !follows(cell, last))
      {
        in.fail("a cell outside the region, or out of order");
      }
      state.cells.at(cell) = readCell(in, known);
      last = cell;
    }
  }
}
}  // namespace traverse::multi_lidar_grid
