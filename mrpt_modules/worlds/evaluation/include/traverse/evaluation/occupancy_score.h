// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <cstdint>
#include <limits>
#include <string>

namespace traverse::evaluation
{
/** Which cells of an occupancy map are judged, and how sharply. */
struct OccupancyParams
{
  std::string map_layer = "occupancy_state";  //!< codes of layers::OccupancyState
  std::string truth_layer = "truth_state";  //!< unknown 0, free 1, occupied 2, overhang 3, ditch 4
  std::string returns_layer = "returns";    //!< of the truth, uint32: what sensors had of the thing
                                            //!< there; where there is none, all where nothing moved
  uint32_t min_returns = 2;                 //!< obstacle cells with fewer are left out
  std::string left_out_layer = "truth_swept";  //!< of the truth, uint8: where something moved
                                               //!< lately no cell is false
  int32_t tolerance_cells = 1;                 //!< a neighbour that far away may be right instead
  double centre_x_m = 0;                       //!< of the circle that is judged
  double centre_y_m = 0;
  double radius_m = std::numeric_limits<double>::infinity();
  double ditch_radius_m = 15;  //!< ditches further from the centre are not judged
};

/** Cells of an occupancy map against the truth; those of several times can be added up. Shares are
 * NaN of nothing. */
struct OccupancyScore
{
  uint64_t obstacles = 0;        //!< true obstacle cells with returns enough
  uint64_t found_obstacles = 0;  //!< of them, obstacles in the map
  uint64_t known_free = 0;       //!< true free cells that the map knows
  uint64_t false_obstacles = 0;  //!< of them, obstacles in the map
  uint64_t false_ditches = 0;    //!< of them, negative in the map
  uint64_t free_in_both = 0;     //!< of the known cells
  uint64_t free_in_either = 0;   //!< of the known cells
  uint64_t ditches = 0;          //!< true ditch cells within ditch_radius_m
  uint64_t found_ditches = 0;    //!< of them, negative in the map
  uint64_t ditches_as_free = 0;  //!< of them, free in the map: where one would drive in
  uint64_t free_cells = 0;       //!< true free cells
  uint64_t unknown_free = 0;     //!< of them, unknown in the map: the blind area

  OccupancyScore& operator+=(const OccupancyScore& other);

  double obstacleRecall() const;
  double falseObstacleRate() const;  //!< of the free cells that the map knows
  double falseDitchRate() const;
  double freeIou() const;
  double ditchRecall() const;
  double ditchAsFreeRate() const;
  double blindShare() const;
};

/** Judges every cell of the truth in the circle. Overhangs count as free, in map and truth.
 *
 * With tolerance, an obstacle (a ditch) is found where the map has one within so many cells; a
 * wrong cell is forgiven where the truth has what the map says within so many, and is then left out
 * of the IoU. A 3 cm error moves a wall at a cell's border into the neighbour.
 *
 * Throws std::invalid_argument where the cells are not of the same size, a layer is missing or of
 * another type. */
OccupancyScore occupancyScore(
    const layers::LayerSet& map, const layers::LayerSet& truth, const OccupancyParams& params = {});
}  // namespace traverse::evaluation
