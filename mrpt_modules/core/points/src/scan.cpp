// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/scan.h>

namespace traverse::points
{
Scan ScanBuffer::view() const
{
  return {stamp, sensor_label, T_base_sensor, x, y, z, time_s, ring, intensity, rgb, nullptr};
}

void ScanBuffer::reserve(size_t n)
{
  for (std::vector<float>* channel : {&x, &y, &z, &time_s, &intensity})
  {
    channel->reserve(n);
  }
  ring.reserve(n);
}
}  // namespace traverse::points
