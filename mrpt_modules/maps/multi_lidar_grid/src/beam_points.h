// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

// No types of Eigen here: beam_points.cpp is compiled for several processors.
namespace traverse::multi_lidar_grid
{
/** How points of the vehicle frame fall into cells, and where the sensor was at their times. */
struct BeamFrame
{
  static constexpr size_t kMostOrigins = 16;

  double to_map[3][4] = {};  //!< of points, m
  double min_x_mm = 0;       //!< of the region; map frame, whole numbers
  double min_y_mm = 0;
  double zero_mm = 0;    //!< heights count from here
  double most_mm = 1e6;  //!< heights further up or down are none
  int32_t cell_mm = 1;
  int32_t edge = 0;      //!< of the region, cells
  double range2_m2 = 0;  //!< of the sensor, squared
  double least2_m2 = 0;  //!< a beam that goes no further along the ground has no direction
  int32_t origins = 1;   //!< at equal steps of time
  float first_s = 0;
  float by_step = 0;                      //!< 1 / s
  std::array<float, kMostOrigins> x_m{};  //!< from the region's corner and zero_mm
  std::array<float, kMostOrigins> y_m{};
  std::array<float, kMostOrigins> z_m{};

  /** Field of view: directions with a first and a last one (counter-clockwise), in the x-y plane of
   * the sensor, whose axes are x_axis, y_axis in the map frame. */
  bool has_view = false;
  bool is_wide = false;                 //!< more than half a turn
  std::array<float, 3> first_normal{};  //!< map frame; positive products are in the view
  std::array<float, 3> last_normal{};
};

/** What one pass over a scan's points says of each. */
struct BeamPoints
{
  static constexpr int32_t kNoCell = -1;

  size_t size = 0;
  std::vector<int32_t> cell;   //!< row * edge + column, or kNoCell
  std::vector<int32_t> z_mm;   //!< above zero_mm, nearest
  std::vector<float> reach_m;  //!< of its beam, along the ground; negative: no beam
  std::vector<float> slope;    //!< of its beam, up per along
  std::vector<float> turn;     //!< azimuth of its beam in the map frame, [0, 1) of a turn from x
  uint64_t bad = 0;            //!< not finite or absurdly far
  uint64_t inside = 0;         //!< with a cell

  void resize(size_t n);
};

struct PointArrays
{
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const float* time_s = nullptr;  //!< nullptr: all at the stamp
  size_t size = 0;
};

/** The same bits on every processor. `points` must have been resized. */
void locate(const BeamFrame& frame, const PointArrays& in, BeamPoints& points);
}  // namespace traverse::multi_lidar_grid
