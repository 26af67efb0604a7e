// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_grid.h"

#include <cmath>

namespace traverse::ground
{
/** What is flat at a column's height. */
struct FlatSurface
{
  float most_span_m = 0;  //!< of a flat column's points
  float same_m = 0;       //!< means apart by less are of one height
};

/** Whether enough of the columns around one of the patch are flat and have its height. */
inline bool isSupported(
    const PatchGrid& grid, int32_t patch, const PlacedColumn& column, const FlatSurface& surface)
{
  constexpr int kSupport = 2;
  constexpr float kSupportShare = 0.3F;
  int all = -1;  // not the column itself
  int same = -1;
  grid.forEachAround(
      patch, column,
      [&](size_t i)
      {
        const PlacedColumn& other = grid.columns()[i];
        ++all;
        same += static_cast<int>(
            other.span_m() <= surface.most_span_m &&
            std::abs(other.mean_m - column.mean_m) < surface.same_m);
      });
  return same >= kSupport && static_cast<float>(same) >= kSupportShare * static_cast<float>(all);
}
}  // namespace traverse::ground
