// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/exclude.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace traverse::points
{
namespace
{
template <class T>
void keep(std::vector<T>& channel, const std::vector<size_t>& kept)
{
  if (channel.empty())
  {
    return;
  }
  for (size_t i = 0; i < kept.size(); ++i)
  {
    channel[i] = channel[kept[i]];
  }
  channel.resize(kept.size());
}

void excludeFromScan(Decoded& decoded, const Eigen::AlignedBox3f& box)
{
  ScanBuffer& scan = decoded.scan;
  std::vector<size_t> kept;
  kept.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    if (!box.contains(Eigen::Vector3f(scan.x[i], scan.y[i], scan.z[i])))
    {
      kept.push_back(i);
    }
  }
  decoded.rejects.add(Reject::excluded, scan.size() - kept.size());
  if (kept.size() == scan.size())
  {
    return;
  }
  if (scan.input_index.empty())
  {
    scan.input_points = static_cast<uint32_t>(scan.size());
    scan.input_index.resize(scan.size());
    std::iota(scan.input_index.begin(), scan.input_index.end(), 0U);
  }
  for (std::vector<float>* channel : {&scan.x, &scan.y, &scan.z, &scan.time_s, &scan.intensity})
  {
    keep(*channel, kept);
  }
  keep(scan.ring, kept);
  keep(scan.rgb, kept);
  keep(scan.input_index, kept);
}

void excludeFromImage(RangeImage& image, const Eigen::AlignedBox3f& box)
{
  const Eigen::Isometry3f T = image.T_base_sensor.cast<float>();
  for (size_t i = 0; i < image.size(); ++i)
  {
    const float c = std::cos(image.elevation_rad[i]);
    const Eigen::Vector3f direction(
        c * std::cos(image.azimuth_rad[i]), c * std::sin(image.azimuth_rad[i]),
        std::sin(image.elevation_rad[i]));
    if (image.beam[i] == Beam::hit && box.contains(T * (direction * image.range_m[i])))
    {
      image.beam[i] = Beam::rejected;
      image.range_m[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
}
}  // namespace

void excludeBox(Decoded& decoded, const Eigen::AlignedBox3f& box)
{
  excludeFromScan(decoded, box);
  excludeFromImage(decoded.image, box);
}
}  // namespace traverse::points
