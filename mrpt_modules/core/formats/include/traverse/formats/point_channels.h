// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace traverse::formats
{
/** What no cloud class of MRPT 2.5.8 can carry, per point of a cloud, in its order: each of the
 * cloud's length, or empty where the sensor has none. */
struct PointChannels
{
  std::vector<uint16_t> ring;  //!< laser, as the recording numbers it
  std::vector<float> time_s;   //!< of the point, relative to the observation's stamp

  bool empty() const { return ring.empty() && time_s.empty(); }
};
}  // namespace traverse::formats
