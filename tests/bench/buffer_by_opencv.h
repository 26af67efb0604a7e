// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#ifdef TRAVERSE_BENCH_OPENCV
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace traverse::bench
{
/** The paper's buffer as OpenCV makes it: cells of 0.2 m, hard 1.8 m, soft 1.2 m. */
struct OpenCvBuffer
{
  cv::Mat obstacles;  //!< distance to the nearest, cells
  cv::Mat laplacian;  //!< of the distance to the hard zone

  /** The code of layers::BufferZone of a cell. */
  uint8_t zoneOf(size_t cell, uint8_t state) const
  {
    const float distance = reinterpret_cast<const float*>(obstacles.data)[cell];
    const bool is_ridge = reinterpret_cast<const float*>(laplacian.data)[cell] < -0.3F;
    if (state == 0 || distance > 15.0001F)
    {
      return 0;
    }
    return distance <= 9.0001F ? 2 : (is_ridge ? 3 : 1);
  }
};

inline OpenCvBuffer bufferByOpenCv(const std::vector<uint8_t>& states, int columns)
{
  cv::setNumThreads(1);
  const int rows = static_cast<int>(states.size()) / columns;
  const cv::Mat cells(rows, columns, CV_8U, const_cast<uint8_t*>(states.data()));
  const cv::Mat is_clear = (cells != 2) & (cells != 3);
  OpenCvBuffer buffer;
  cv::distanceTransform(is_clear, buffer.obstacles, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  const cv::Mat is_beyond = buffer.obstacles > 9.0001F;
  cv::Mat distances;
  cv::distanceTransform(is_beyond, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Laplacian(distances, buffer.laplacian, CV_32F, 5, 1 / 48.);
  return buffer;
}
}  // namespace traverse::bench
#endif
