// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/sample_layers.h"

#include <limits>

namespace traverse::testing
{
/** 3 x 2 cells of 0.2 m with a layer of each type; one cell is unknown in all, one only in some. */
inline layers::LayerSet everyType(geometry::CellIndex corner)
{
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr double kNanDouble = std::numeric_limits<double>::quiet_NaN();
  layers::LayerSet set = drawnClasses(
      {"14.",  //
       "2.3"},
      corner);
  set.layers.push_back(
      {"height_mean", "m", std::vector<float>{1.5F, kNan, -0.1F, 1e-20F, 3.25e7F, kNan}});
  set.layers.push_back({"point_count", "1", std::vector<uint32_t>{4294967295U, 0, 3, 4, 5, 0}});
  set.layers.push_back(
      {"last_seen_s", "s",
       std::vector<double>{
           1519637026.123456, 1e7 + 0.001, -2.5, kNanDouble, 4503599627370497.5, kNanDouble}});
  return set;
}
}  // namespace traverse::testing
