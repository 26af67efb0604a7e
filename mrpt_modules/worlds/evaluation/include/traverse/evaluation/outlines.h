// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace traverse::evaluation
{
/** A convex polygon of the map frame, m, either way round, the first corner not repeated. */
using Polygon = std::vector<Eigen::Vector2d>;

/** Where a thing stands in truth: one polygon or more. */
struct TrueOutline
{
  uint32_t object = 0;
  std::vector<Polygon> polygons;
};

/** How well the outline of one thing was found; areas are of squares of cells, so of half a cell's
 * error in the best case. */
struct OutlineScore
{
  uint32_t object = 0;
  double true_area_m2 = 0;
  double found_area_m2 = 0;
  double area_error_m2 = 0;  //!< of what is in one of the two only (in cells whose middle it is)
  double hausdorff_m = 0;    //!< farthest place of one of the two from the other; to half a cell
};

struct OutlineScores
{
  std::vector<OutlineScore> things;  //!< those that were found
  std::vector<uint32_t> not_found;   //!< those without any obstacle cell within one cell of them
  uint64_t clusters = 0;             //!< connected obstacle cells of the map (8 neighbours)
  uint64_t foreign_clusters = 0;     //!< of them, more than one cell from every thing
};

/** Clusters of obstacle cells of the map against outlines. Each cell of a cluster belongs to the
 * nearest thing that the cluster touches (within one cell). Polygons of fewer than three corners
 * or of no area are left out. Throws std::invalid_argument where the map has no class layer, and
 * std::length_error for outlines that are too large, too detailed or too many to go through. */
OutlineScores outlineScores(const layers::LayerSet& map, const std::vector<TrueOutline>& outlines);

/** Distance of a place from a convex polygon, m; 0 within. */
double distanceTo(const Polygon& polygon, const Eigen::Vector2d& place);

/** Area of a polygon, m^2. */
double areaOf(const Polygon& polygon);
}  // namespace traverse::evaluation
