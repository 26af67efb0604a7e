// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/fusion.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <algorithm>

namespace traverse::multi_lidar_grid
{
namespace
{
void add(const UnitMap& unit, uint32_t bit, LatestMap& map)
{
  const geometry::CellRect known =
      geometry::intersection(geometry::intersection(map.extent, unit.touched), unit.cells.region());
  const auto width = static_cast<size_t>(map.extent.width());
  unit.cells.forEachIn(
      known,
      [&](geometry::CellIndex c, const UnitCell& cell)
      {
        if (cell.state == layers::OccupancyState::unknown)
        {
          return;
        }
        const size_t i = static_cast<size_t>(c.y - map.extent.min.y) * width +
                         static_cast<size_t>(c.x - map.extent.min.x);
        const auto before = static_cast<layers::OccupancyState>(map.states[i]);
        map.states[i] = static_cast<uint8_t>(stronger(before, cell.state));
        map.seen_by[i] |= bit;
      });
}
}  // namespace

LatestMap fuseLatest(const State& state, const Params& params, const geometry::CellRect& window)
{
  LatestMap map;
  map.extent = window.empty() ? geometry::CellRect{} : window;
  const size_t size =
      static_cast<size_t>(map.extent.width()) * static_cast<size_t>(map.extent.height());
  map.states.assign(size, 0);
  map.seen_by.assign(size, 0);
  for (const Sensor& sensor : state.sensors.all())
  {
    if (sensor.has_cloud && counts(healthOf(sensor, state.now, params)))
    {
      add(sensor.latest, state.sensors.bitOf(sensor), map);
    }
  }
  return map;
}
}  // namespace traverse::multi_lidar_grid
