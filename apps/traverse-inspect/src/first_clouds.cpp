// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "first_clouds.h"

#include "log_summary.h"

#include <traverse/formats/png.h>
#include <traverse/formats/safe_file.h>
#include <traverse/rendering/offscreen.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
constexpr size_t kColours = 12;
constexpr double kPicture_m = 60;  // further points are not drawn

/** Blue, green, yellow, red for 0..1. */
layers::Colour heightColour(double share)
{
  const auto ramp = [&](double middle)
  { return static_cast<uint8_t>(220 * std::clamp(1.5 - std::abs(share - middle) * 4, 0.0, 1.0)); };
  return {ramp(0.85), ramp(0.5), ramp(0.15)};
}

/** Points by height, in steps, lowest first; the outermost hundredths share a colour. */
std::vector<rendering::PointSet> byHeight(const points::ScanBuffer& scan)
{
  std::vector<float> heights(scan.z);
  std::sort(heights.begin(), heights.end());
  const double low = heights[heights.size() / 100];
  const double high = heights[heights.size() - 1 - heights.size() / 100];
  std::vector<rendering::PointSet> sets(kColours);
  for (size_t i = 0; i < kColours; ++i)
  {
    sets[i].colour = heightColour(static_cast<double>(i) / (kColours - 1));
    sets[i].size_px = 2;
  }
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p(scan.x[i], scan.y[i], scan.z[i]);
    if (p.norm() <= kPicture_m)
    {
      const double share = (p.z() - low) / std::max(1e-6, high - low);
      sets[static_cast<size_t>(std::clamp(share, 0.0, 1.0) * (kColours - 1))].points.push_back(p);
    }
  }
  std::erase_if(sets, [](const rendering::PointSet& set) { return set.points.empty(); });
  return sets;
}
}  // namespace

std::vector<std::filesystem::path> drawFirstClouds(
    const ScanCensus& census, const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::vector<std::filesystem::path> files;
  for (const auto& [label, sensor] : census)
  {
    if (sensor.first.scan.size() == 0)
    {
      continue;
    }
    rendering::SceneContent content;
    content.T_map_base = Eigen::Isometry3d::Identity();
    content.scans = byHeight(sensor.first.scan);
    const rendering::Overlay overlay{
        fmt::format("{}, {} points", sensorName(label, "scan"), sensor.first.scan.size()),
        {},
        true};
    const std::string name = formats::safeFileName(label.empty() ? "unnamed" : label);
    files.push_back(folder / (name + "_top.png"));
    formats::writeFile(files.back(), formats::png(rendering::renderTopView(content, overlay)));
    files.push_back(folder / (name + "_3d.png"));
    formats::writeFile(files.back(), formats::png(rendering::renderPerspective(content, overlay)));
  }
  return files;
}
}  // namespace traverse::app
