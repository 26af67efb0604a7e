// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wire.h"

namespace traverse::logs
{
void FrameWriter::put(const std::string& text)
{
  put(uint64_t{text.size()});
  bytes_.insert(bytes_.end(), text.begin(), text.end());
}

void FrameWriter::put(const Eigen::Isometry3d& pose)
{
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      put(pose.matrix()(row, column));
    }
  }
}

size_t FrameWriter::begin(FrameType type)
{
  const size_t start = bytes_.size();
  put(FrameHeader{.type = static_cast<uint32_t>(type)});
  return start;
}

void FrameWriter::finish(size_t start)
{
  const uint64_t length = bytes_.size() - start - sizeof(FrameHeader);
  std::memcpy(bytes_.data() + start + offsetof(FrameHeader, length), &length, sizeof(length));
}

void FrameWriter::add(const points::Decoded& decoded)
{
  const size_t start = begin(FrameType::scan);
  const points::ScanBuffer& scan = decoded.scan;
  put(scan.stamp);
  put(scan.sensor_label);
  put(scan.T_base_sensor);
  for (const auto* channel : {&scan.x, &scan.y, &scan.z, &scan.time_s, &scan.intensity})
  {
    put(*channel);
  }
  put(scan.ring);
  put(scan.rgb);
  put(scan.input_index);
  put(scan.input_points);
  const points::RangeImage& image = decoded.image;
  put(image.T_base_sensor);
  put(image.rows);
  put(image.columns);
  put(uint8_t{image.closes});
  put(image.max_range_m);
  put(image.beam);
  for (const auto* channel :
       {&image.range_m, &image.azimuth_rad, &image.elevation_rad, &image.time_s})
  {
    put(*channel);
  }
  put(decoded.rejects.count);
  finish(start);
}

void FrameWriter::add(const CountFrame& count)
{
  const size_t start = begin(FrameType::count);
  put(count.what);
  put(count.type);
  put(count.reason);
  finish(start);
}

void FrameWriter::add(const poses::StampedPose& pose)
{
  const size_t start = begin(FrameType::pose);
  put(pose.time);
  put(pose.T_map_base);
  finish(start);
}

void FrameWriter::add(const DamageFrame& damage)
{
  const size_t start = begin(FrameType::damage);
  put(uint8_t{damage.not_a_log});
  put(damage.message);
  finish(start);
}

void FrameWriter::add(const SightingFrame& sighting)
{
  const size_t start = begin(FrameType::sighting);
  put(sighting.label);
  put(sighting.type);
  put(sighting.stamp);
  put(sighting.T_base_sensor);
  finish(start);
}

void FrameWriter::add(FrameType bare)
{
  finish(begin(bare));
}
}  // namespace traverse::logs
