// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_points.h"

#include <traverse/multi_lidar_grid/unit_map.h>

#include <cstdint>
#include <vector>

namespace traverse::multi_lidar_grid
{
/** The paper's virtual lidar: in the plane, from the middle of the cell in which the lidar stands,
 * a ray to the middle of every cell of its field of view. A ray ends at the first obstacle cell
 * that its direction touches, so that none slips between two diagonal ones. */
class PaperLidar
{
 public:
  /** Frees the cells that a ray reaches and nothing is known of, and returns the rectangle looked
   * at. `stand`: the lidar's cell; obstacles come from the map. */
  geometry::CellRect trace(
      const BeamFrame& frame, geometry::CellIndex stand, uint8_t up_to, UnitMap& map);

 private:
  void layOut(int32_t edge);
  void block(int32_t dx, int32_t dy);

  int32_t edge_ = 0;
  std::vector<uint16_t> quarter_;  // directions of cells with x, y >= 0, row by row
  std::vector<int32_t> depth2_;    // of each direction, squared cells to the first obstacle
};
}  // namespace traverse::multi_lidar_grid
