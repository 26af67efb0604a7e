// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster.h"
#include "refuse.h"

#include <traverse/formats/cloud_file.h>
#include <traverse/simulation/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace traverse::simulation
{
namespace
{
constexpr double kBucket_m = 5;
constexpr int kMostRings = 40;
constexpr size_t kMostNodes = 1'000'000;
constexpr size_t kNearest = 6;

struct GroundPoint
{
  double x_m = 0;
  double y_m = 0;
  double z_m = 0;
};

/** Points of the scene's surroundings, by buckets of 5 m. */
class PointBuckets
{
 public:
  PointBuckets(const formats::CloudFile& cloud, const TerrainParams& params, const Area& around)
  {
    for (size_t i = 0; i < cloud.size(); ++i)
    {
      const GroundPoint p{
          cloud.x[i] - params.origin_x_m, cloud.y[i] - params.origin_y_m, cloud.z[i]};
      const bool inside = p.x_m >= around.min_x_m && p.x_m <= around.max_x_m &&
                          p.y_m >= around.min_y_m && p.y_m <= around.max_y_m &&
                          std::isfinite(p.z_m);
      if (inside)
      {
        buckets_[{bucket(p.x_m), bucket(p.y_m)}].push_back(p);
      }
    }
  }

  bool empty() const { return buckets_.empty(); }

  /** Weighted mean of the nearest points; NaN where none is within 200 m. */
  float heightAt(double x_m, double y_m) const
  {
    std::vector<std::pair<double, double>> found;  // squared distance, height
    for (int ring = 0; ring <= kMostRings; ++ring)
    {
      addRing(x_m, y_m, ring, found);
      std::sort(found.begin(), found.end());
      const double sure_m = ring * kBucket_m;
      if (found.size() >= kNearest && found[kNearest - 1].first <= sure_m * sure_m)
      {
        break;
      }
    }
    double sum = 0;
    double weights = 0;
    for (size_t i = 0; i < std::min(kNearest, found.size()); ++i)
    {
      const double weight = 1 / (found[i].first + 1e-4);
      sum += weight * found[i].second;
      weights += weight;
    }
    return weights > 0 ? static_cast<float>(sum / weights)
                       : std::numeric_limits<float>::quiet_NaN();
  }

 private:
  static int bucket(double v_m) { return static_cast<int>(std::floor(v_m / kBucket_m)); }

  void addRing(
      double x_m, double y_m, int ring, std::vector<std::pair<double, double>>& found) const
  {
    const int cx = bucket(x_m);
    const int cy = bucket(y_m);
    for (int dy = -ring; dy <= ring; ++dy)
    {
      const int step = std::abs(dy) == ring || ring == 0 ? 1 : 2 * ring;
      for (int dx = -ring; dx <= ring; dx += step)
      {
        const auto at = buckets_.find({cx + dx, cy + dy});
        if (at == buckets_.end())
        {
          continue;
        }
        for (const GroundPoint& p : at->second)
        {
          const double ex = p.x_m - x_m;
          const double ey = p.y_m - y_m;
          found.emplace_back(ex * ex + ey * ey, p.z_m);
        }
      }
    }
  }

  std::map<std::pair<int, int>, std::vector<GroundPoint>> buckets_;
};
}  // namespace

Raster pointRaster(const TerrainParams& params, const SceneParams& scene)
{
  constexpr double kMargin_m = 30;
  const SceneExtentParams& e = scene.extent;
  Raster raster;
  const double across_x = std::ceil((e.max_x_m - e.min_x_m) / params.spacing_m) + 1;
  const double across_y = std::ceil((e.max_y_m - e.min_y_m) / params.spacing_m) + 1;
  if (across_x * across_y > static_cast<double>(kMostNodes))
  {
    refuse("spacing_m", params.spacing_m, "at most 1 million nodes on the scene's area");
  }
  raster.columns = static_cast<size_t>(across_x);
  raster.rows = static_cast<size_t>(across_y);
  raster.to_node /= params.spacing_m;
  raster.shift = -Eigen::Vector2d(e.min_x_m, e.min_y_m) / params.spacing_m;
  const PointBuckets points(
      formats::readCloud(scene.folder / params.file), params,
      {e.min_x_m - kMargin_m, e.min_y_m - kMargin_m, e.max_x_m + kMargin_m, e.max_y_m + kMargin_m});
  if (points.empty())
  {
    refuse("origin_x_m", params.origin_x_m, "an origin near the file's points");
  }
  raster.heights_m.reserve(raster.columns * raster.rows);
  for (size_t row = 0; row < raster.rows; ++row)
  {
    const double y = e.min_y_m + static_cast<double>(row) * params.spacing_m;
    for (size_t column = 0; column < raster.columns; ++column)
    {
      raster.heights_m.push_back(
          points.heightAt(e.min_x_m + static_cast<double>(column) * params.spacing_m, y));
    }
  }
  return raster;
}
}  // namespace traverse::simulation
