// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <vector>

namespace traverse::evaluation
{
using Cluster = std::vector<geometry::CellIndex>;

/** Cells of one class that hang together (8 neighbours), in the order of their first cells. Throws
 * std::invalid_argument where the map has no class layer of bytes. */
std::vector<Cluster> clustersOf(const layers::LayerSet& map, uint8_t code);
}  // namespace traverse::evaluation
