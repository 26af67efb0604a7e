// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <mrpt/opengl/CSetOfTriangles.h>

#include <string_view>

namespace traverse::rendering
{
/** The class layer's colours on a surface through the cells' heights, for MRPT's scenes.
 *
 * Each cell with a finite height is two triangles in its class's legend colour, without shades, so
 * that the colours are the legend's also in viewers; a corner lies at the mean height of those
 * cells around it that differ from the cell by most_relief_m at most (a wall does not drag the road
 * beside it up). Coordinates of the map frame.
 *
 * Throws std::invalid_argument where there is no class layer or no float layer of that name. */
mrpt::opengl::CSetOfTriangles::Ptr layerSurface(
    const layers::LayerSet& set, std::string_view height_layer, float most_relief_m = 0.5F);
}  // namespace traverse::rendering
