// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "messages.h"

#include <traverse/formats/point_channels.h>

namespace traverse::ros_bags
{
/** The points of a cloud, column by column, in its order; what it does not have is empty. */
struct CloudColumns
{
  std::vector<float> x, y, z;
  std::vector<float> intensity;  //!< as it stands there
  float intensity_full = 0;      //!< its largest possible value, where the type says so; else 0
  std::vector<uint32_t> rgb;     //!< 0xRRGGBB
  formats::PointChannels channels;
  std::vector<std::string> notes;  //!< columns that are there and make no sense
};

/** Takes a PointCloud2 apart. The names and units that drivers use are understood: intensity
 * (intensities, reflectivity, i), ring (channel, line, laser_id), time (t, timestamp, time_stamp,
 * offset_time, time_offset) as seconds (float), nanoseconds (integers), or absolute seconds,
 * microseconds or nanoseconds (told by their magnitude), rgb (rgba, or r g b).
 *
 * Times come out relative to stamp_ns; where one is further than 10 s from it, the cloud goes
 * without. Coordinates may be NaN. Throws formats::FormatError for a cloud without x, y, z. */
CloudColumns readColumns(const PointCloud& cloud, int64_t stamp_ns);
}  // namespace traverse::ros_bags
