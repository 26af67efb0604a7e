// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The map for users of MRPT's own occupancy grids.
#include <traverse/formats/gzip.h>
#include <traverse/maps/CWrappableMultiLidarGrid.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace traverse::maps
{
namespace
{
using layers::OccupancyState;

constexpr double kFarthest_m = 1e5;  // MRPT's grids have float coordinates: 8 mm there

float freeProbabilityOf(OccupancyState state)
{
  switch (state)
  {
    case OccupancyState::obstacle:
    case OccupancyState::negative:
      return 0.01F;
    case OccupancyState::free:
    case OccupancyState::overhang:
      return 0.99F;
    case OccupancyState::unknown:
      break;
  }
  return 0.5F;
}

bool isNear(const geometry::Lattice& lattice, const geometry::CellRect& region)
{
  const std::array<int32_t, 4> edges = {region.min.x, region.min.y, region.max.x, region.max.y};
  return std::all_of(
      edges.begin(), edges.end(),
      [&](int32_t edge) { return std::abs(lattice.edge_m(edge)) <= kFarthest_m; });
}

mrpt::maps::COccupancyGridMap2D gridOf(const multi_lidar_grid::State& state)
{
  const geometry::Lattice& lattice = state.lattice;
  const geometry::CellRect& region = state.cells.region();
  const auto at = [&](int32_t edge) { return static_cast<float>(lattice.edge_m(edge)); };
  mrpt::maps::COccupancyGridMap2D grid;
  grid.setSize(
      at(region.min.x), at(region.max.x), at(region.min.y), at(region.max.y),
      static_cast<float>(lattice.cell_m()));
  state.cells.forEach(
      [&](geometry::CellIndex c, const multi_lidar_grid::Cell& cell)
      { grid.setCell(c.x - region.min.x, c.y - region.min.y, freeProbabilityOf(cell.state)); });
  return grid;
}
}  // namespace

std::vector<layers::ExtraFile> CWrappableMultiLidarGrid::extraFiles() const
{
  if (isEmpty() || !isNear(state_.lattice, state_.cells.region()))
  {
    return {};
  }
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << gridOf(state_);
  const std::string_view bytes(
      static_cast<const char*>(stream.getRawBufferData()),
      static_cast<size_t>(stream.getTotalBytesCount()));
  return {{".gridmap", formats::gzip(bytes)}};
}
}  // namespace traverse::maps
