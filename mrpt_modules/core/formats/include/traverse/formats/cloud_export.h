// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <string>

namespace traverse::formats
{
/** All layers as a PLY point cloud (binary, little endian): a point per cell of which any layer
 * says anything, row by row from the smallest y.
 *
 * Properties: x y z (double; the cell's centre, m of the map frame; z is height_mean, else
 * ground_height, else 0), red green blue of the cell's class, cell_x cell_y (the cell's index),
 * then each layer by name in its own type (uchar, uint, float, double); unknown is NaN in floating
 * layers. Characters that PLY's header cannot hold become '_' in names. The same layers give the
 * same bytes. Throws std::invalid_argument where a layer is not of the extent's size. */
std::string plyCloud(const layers::LayerSet& set);

/** The same as a PCD file (v0.7, binary) with fields x y z rgb cell_x cell_y and the layers. x, y
 * and z are float, as PCL wants them: exact to 1 mm within 16 km of map zero; beyond, use cell_x
 * and cell_y. */
std::string pcdCloud(const layers::LayerSet& set);
}  // namespace traverse::formats
