// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "occupancy_pictures.h"

#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>

#include <string>
#include <vector>

namespace traverse::testing
{
/** The sections of an archive of two cells, to be falsified with good checksums. */
struct Forgery
{
  multi_lidar_grid::Params params = smallMap().params;
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
    formats::ByteWriter grid;
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
    formats::ByteWriter out;
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
    formats::ByteWriter out;
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
    formats::ArchiveWriter writer{
        std::string(multi_lidar_grid::kArchiveKind), multi_lidar_grid::kArchiveVersion};
    writer.section("OPTS", formats::optionBytes(params));
    writer.section("VEHI", formats::optionBytes(vehicle));
    writer.section("GRID", gridSection());
    writer.section("SENS", sensorSection());
    writer.section("CELL", cellSection());
    return writer.finish();
  }
};
}  // namespace traverse::testing
