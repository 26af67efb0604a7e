// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <string>
#include <vector>

namespace traverse::formats
{
/** A map that ROS map_server and MRPT's ros-map-yaml2mrpt load: a PGM picture and its YAML. The
 * picture's top row has the largest y; `origin` in the YAML is the lower left corner. */
struct OccupancyImage
{
  std::string pgm;
  std::string yaml;
};

/** What class codes mean to a planner that knows occupied, free and unknown only. Codes in neither
 * list are free. */
struct OccupancyMeaning
{
  std::vector<uint8_t> occupied = {4};  //!< obstacle
  std::vector<uint8_t> unknown = {0};   //!< undefined
};

/** The class layer, mode trinary: occupied is black (0), unknown 205, free 254, with the thresholds
 * 0.65 and 0.196 that map_saver writes, so that every reader tells the three apart.
 *
 * `pgm_name` is the picture's file name beside the YAML. Throws std::invalid_argument where there
 * is no class layer, or the name is not a plain one (see safeFileName). */
OccupancyImage occupancyOfClasses(
    const layers::LayerSet& set, const std::string& pgm_name, const OccupancyMeaning& meaning = {});

/** A layer of 0 (easiest) to 100 (obstacle), mode scale: map_server gives back the index itself
 * (to 1, pixels have 8 bits). A PGM has no way to say unknown in this mode: undefined cells get
 * 50, the middle, which MRPT takes for unknown and map_server for a middling cost. Where unknown
 * must be told, use occupancyOfClasses.
 *
 * Throws std::invalid_argument where the sizes do not fit or the name is not a plain one. */
OccupancyImage occupancyOfIndex(
    const layers::LayerSet& set, const layers::Layer& index, const std::string& pgm_name);
}  // namespace traverse::formats
