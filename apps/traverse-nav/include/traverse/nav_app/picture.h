// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/png.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/layers/layer_set.h>
#include <traverse/nav_app/closed_loop.h>

#include <span>
#include <vector>

namespace traverse::app
{
/** What is drawn over a costmap. */
struct PictureContent
{
  std::span<const DriveRecord> driven;         //!< a line, from blue to red by speed
  const navigation::Plan* plan = nullptr;      //!< a green line
  std::vector<navigation::Goal> goals;         //!< rings
  const geometry::Vehicle* vehicle = nullptr;  //!< its outline at the last record
};

/** The costmap from above, y up, cell_px pixels a cell, with what is drawn over it. Open ground is
 * the darker the more a metre of it costs. Throws std::invalid_argument where the costmap is empty.
 */
formats::Raster costPicture(
    const navigation::Costmap& costmap, const PictureContent& content, int cell_px);

/** What the colours mean. */
std::vector<layers::LegendEntry> costLegend();
}  // namespace traverse::app
