// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "archive_parts.h"

#include <traverse/formats/archive.h>
#include <traverse/formats/option_bytes.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <cmath>
#include <stdexcept>

namespace traverse::multi_lidar_grid
{
namespace
{
/** Options alone may ask for gigabytes; a few hundred hostile bytes shall not. */
void checkMemory(const Params& params, uint32_t sensors)
{
  constexpr double kMostBytes = 4e9;
  const geometry::Torus torus(
      static_cast<int32_t>(std::ceil(params.window_m / params.cell_size_m)));
  const double bytes = static_cast<double>(torus.size()) *
                       static_cast<double>(sizeof(Cell) + sensors * sizeof(UnitCell));
  if (bytes > kMostBytes)
  {
    throw formats::FormatError(
        std::string(kArchiveKind) + " archive: a map of more than 4 GB in memory");
  }
}
}  // namespace

std::string archive(const State& state, const Params& params, const geometry::Vehicle& vehicle)
{
  formats::ArchiveWriter writer(std::string(kArchiveKind), kArchiveVersion);
  writer.section("OPTS", formats::optionBytes(params));
  writer.section("VEHI", formats::optionBytes(vehicle));
  writer.section("GRID", gridBytes(state));
  writer.section("SENS", sensorBytes(state.sensors));
  writer.section("CELL", cellBytes(state.cells));
  return writer.finish();
}

Map fromArchive(std::string_view bytes)
{
  const formats::ArchiveReader reader(bytes, kArchiveKind, kArchiveVersion);
  try
  {
    const auto params = formats::readOptionBytes<Params>(reader.reader("OPTS"));
    const auto vehicle = formats::readOptionBytes<geometry::Vehicle>(reader.reader("VEHI"));
    check(params, vehicle);
    checkMemory(params, sensorCount(reader.reader("SENS")));
    Map map{params, vehicle, State(params, vehicle)};
    readGrid(reader.reader("GRID"), map.state);
    readSensors(reader.reader("SENS"), map.state);
    readCells(reader.reader("CELL"), map.state);
    return map;
  }
  catch (const options::OptionError& e)
  {
    throw formats::FormatError(std::string(kArchiveKind) + " archive: " + e.what());
  }
}
}  // namespace traverse::multi_lidar_grid
