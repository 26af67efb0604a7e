// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <traverse/layers/occupancy_state.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace traverse::layers
{
namespace
{
constexpr size_t kReach = 2;  // of the kernel
constexpr float kScale = 1.0F / 48;
constexpr float kThreshold = -0.3F;

/** The sum of the second differences in x and y, [1 0 -2 0 1], each smoothed across by
 * [1 4 6 4 1]: a quarter of the kernel, which is symmetric. */
constexpr std::array<std::array<float, 3>, 3> kKernel = {{{-24, -8, 4}, {-8, 0, 4}, {4, 4, 2}}};

/** Distances to the hard buffer, capped beyond the kernel's reach of what is soft, so that the cap
 * makes no ridge there. */
std::vector<float> distancesTo(std::span<const uint8_t> is_hard, size_t columns, int32_t soft_cells)
{
  const int32_t cap = soft_cells + 5;
  DistanceTransform transform(is_hard, static_cast<int32_t>(columns), cap * cap);
  std::vector<float> distances;
  distances.reserve(is_hard.size());
  NearestRow row;
  for (int32_t y = 0; y < transform.rows(); ++y)
  {
    transform.row(y, row);
    for (const int32_t squared : row.squared)
    {
      distances.push_back(std::sqrt(static_cast<float>(std::min(squared, cap * cap))));
    }
  }
  return distances;
}

float laplacianAt(const float* middle, size_t columns)
{
  const auto stride = static_cast<std::ptrdiff_t>(columns);
  float sum = 0;
  for (int y = -2; y <= 2; ++y)
  {
    for (int x = -2; x <= 2; ++x)
    {
      sum += kKernel[static_cast<size_t>(std::abs(y))][static_cast<size_t>(std::abs(x))] *
             middle[y * stride + x];
    }
  }
  return sum * kScale;
}
}  // namespace

void cutByLaplacian(const Buffer& buffer, std::span<const uint8_t> is_hard, int32_t soft_cells)
{
  const size_t columns = buffer.columns;
  const size_t rows = buffer.zones.size() / columns;
  const std::vector<float> distances = distancesTo(is_hard, columns, soft_cells);
  for (size_t y = kReach; y + kReach < rows; ++y)
  {
    for (size_t x = kReach; x + kReach < columns; ++x)
    {
      uint8_t& zone = buffer.zones[y * columns + x];
      if (zone == static_cast<uint8_t>(BufferZone::soft) &&
          laplacianAt(&distances[y * columns + x], columns) < kThreshold)
      {
        zone = static_cast<uint8_t>(BufferZone::strip);
      }
    }
  }
}
}  // namespace traverse::layers
