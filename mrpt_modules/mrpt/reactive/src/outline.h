// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace traverse::reactive
{
/** How many of the points lie in the vehicle's outline: an even-odd count of its edges. */
inline size_t countInside(
    const geometry::Vehicle& vehicle, const std::vector<Eigen::Vector3f>& points)
{
  const auto& xs = vehicle.footprint_xs_m;
  const auto& ys = vehicle.footprint_ys_m;
  const auto lies_within = [&](const Eigen::Vector3f& p)
  {
    bool is_inside = false;
    for (size_t i = 0, j = xs.size() - 1; i < xs.size(); j = i++)
    {
      if ((ys[i] > p.y()) != (ys[j] > p.y()) &&
          p.x() < xs[i] + (p.y() - ys[i]) / (ys[j] - ys[i]) * (xs[j] - xs[i]))
      {
        is_inside = !is_inside;
      }
    }
    return is_inside;
  };
  return static_cast<size_t>(std::count_if(points.begin(), points.end(), lies_within));
}

/** Of the box that the outline lies in. */
inline double halfWidth_m(const geometry::Vehicle& vehicle)
{
  const auto [right, left] =
      std::minmax_element(vehicle.footprint_ys_m.begin(), vehicle.footprint_ys_m.end());
  return (*left - *right) / 2;
}
}  // namespace traverse::reactive
