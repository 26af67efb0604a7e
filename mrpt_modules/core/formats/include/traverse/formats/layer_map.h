// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/report.h>
#include <traverse/layers/layer_set.h>

#include <array>
#include <cstddef>
#include <span>

namespace traverse::formats
{
/** How much of a page one map may take; beyond, its cells are put together to squares. */
struct LayerMapLimits
{
  size_t cells = 3'000'000;
  size_t bytes = size_t{6} << 20U;  //!< of text in the page
};

/** The layers as a map to explore in a report: the rectangle of the cells that are known, with the
 * trajectory over it.
 *
 * Where the map is larger than the limits, squares of 2 x 2, 4 x 4 ... cells take the place of
 * cells, and the caption says so; a square shows all values of one cell of it, one of the highest
 * class code. Floats keep 16 significant bits, as many as the page shows; doubles the 24 of a
 * float over the layer's smallest value. A trajectory is thinned to some thousand points. Throws
 * std::invalid_argument where a layer is not of the extent's size. */
LayerMap layerMap(
    const layers::LayerSet& set,
    std::span<const std::array<double, 3>> trajectory_m,
    const LayerMapLimits& limits = {});
}  // namespace traverse::formats
