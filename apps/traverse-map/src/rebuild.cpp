// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rebuild.h"

#include "mapping.h"

#include <traverse/common_app/input_file.h>
#include <traverse/common_app/interrupt.h>
#include <traverse/common_app/progress.h>
#include <traverse/formats/octree_file.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>
#include <tuple>

namespace traverse::app
{
namespace
{
using formats::OctreeKey;

constexpr double kWidestTile_m = 20;
constexpr double kNarrowestTile_m = 1;

/** Squares of leaves seen from above. */
struct Tiling
{
  double resolution_m = 0;
  int side = 1;  //!< leaves along a tile's edge

  int of(uint16_t k) const { return k / side; }

  /** Middle of tile i along an axis, m. */
  double middle_m(int i) const { return (i * side - OctreeKey::kZero + 0.5 * side) * resolution_m; }

  auto order(OctreeKey k) const { return std::tuple(of(k.y), of(k.x), k.y, k.x, k.z); }
};

double narrowestPiece_m(const std::vector<BuiltMap>& maps)
{
  double edge_m = kWidestTile_m;
  for (const BuiltMap& map : maps)
  {
    edge_m = std::min(edge_m, map.consumer->pieceEdge_m());
  }
  return edge_m;
}

uint16_t partOf(std::vector<uint16_t>& heights, size_t i)
{
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(i);
  std::nth_element(heights.begin(), at, heights.end());
  return *at;
}

/** Height of the ground in the middle of a tile whose leaves are in order: of the lowest leaves of
 * its columns the median near the middle, or the lower quarter of all where few are near. */
double groundOf_m(std::span<const OctreeKey> tile, const Tiling& tiling)
{
  constexpr double kNear_m = 2;
  constexpr size_t kFew = 10;
  const double x_m = tiling.middle_m(tiling.of(tile.front().x));
  const double y_m = tiling.middle_m(tiling.of(tile.front().y));
  std::vector<uint16_t> all;
  std::vector<uint16_t> near;
  for (size_t i = 0; i < tile.size(); ++i)
  {
    if (i > 0 && tile[i].x == tile[i - 1].x && tile[i].y == tile[i - 1].y)
    {
      continue;  // not the lowest of its column
    }
    all.push_back(tile[i].z);
    if (std::abs(formats::leafCentre_m(tile[i].x, tiling.resolution_m) - x_m) <= kNear_m &&
        std::abs(formats::leafCentre_m(tile[i].y, tiling.resolution_m) - y_m) <= kNear_m)
    {
      near.push_back(tile[i].z);
    }
  }
  const uint16_t k =
      near.size() < kFew ? partOf(all, all.size() / 4) : partOf(near, near.size() / 2);
  return formats::leafCentre_m(k, tiling.resolution_m);
}

points::ScanBuffer pointsOf(
    std::span<const OctreeKey> tile, double resolution_m, const Eigen::Vector3d& origin)
{
  points::ScanBuffer scan;
  scan.T_base_sensor.translation().setConstant(std::numeric_limits<double>::quiet_NaN());
  scan.sensor_label = "octree";
  scan.reserve(tile.size());
  for (const OctreeKey& k : tile)
  {
    scan.x.push_back(static_cast<float>(formats::leafCentre_m(k.x, resolution_m) - origin.x()));
    scan.y.push_back(static_cast<float>(formats::leafCentre_m(k.y, resolution_m) - origin.y()));
    scan.z.push_back(static_cast<float>(formats::leafCentre_m(k.z, resolution_m) - origin.z()));
  }
  return scan;
}

void insertTile(
    std::span<const OctreeKey> tile,
    const Tiling& tiling,
    const Settings& settings,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics)
{
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.translation() = Eigen::Vector3d(
      tiling.middle_m(tiling.of(tile.front().x)), tiling.middle_m(tiling.of(tile.front().y)),
      groundOf_m(tile, tiling) + settings.vehicle.base_height_m);
  const points::ScanBuffer scan = pointsOf(tile, tiling.resolution_m, T_map_base.translation());
  const poses::PoseTrack track = poses::PoseTrack::constant(T_map_base);
  ++metrics.scans;
  metrics.points += scan.size();
  for (size_t i = 0; i < maps.size(); ++i)
  {
    metrics.times.during("insert", [&] { insert(scan.view(), track, maps[i], metrics.maps[i]); });
  }
}

/** Cells are read by counting points, and a leaf gives one. */
void noteCoarseLeaves(double resolution_m, const std::vector<BuiltMap>& maps, RunMetrics& metrics)
{
  for (const BuiltMap& map : maps)
  {
    const double cell_m = latticeOf(map).cell_m();
    if (2 * resolution_m > cell_m)
    {
      metrics.warnings.push_back(fmt::format(
          "{}: leaves of {} m are one point each, few for cells of {} m: most may be undefined",
          map.title(), resolution_m, cell_m));
    }
  }
}

void noteLeavesLeftOut(RunMetrics& metrics)
{
  for (const MapMetrics& map : metrics.maps)
  {
    if (map.outside > 0)
    {
      metrics.warnings.push_back(fmt::format(
          "{}: {} leaves lie outside its extent, or too far above or below the ground of their "
          "tile",
          map.name, map.outside));
    }
  }
}
}  // namespace

void checkRebuildable(const std::vector<BuiltMap>& maps)
{
  for (const BuiltMap& map : maps)
  {
    const std::string obstacle = map.consumer->mergeObstacle();
    if (!obstacle.empty())
    {
      throw config::ConfigError(fmt::format(
          "--rebuild puts a map together piece by piece; {}: {}", map.title(), obstacle));
    }
    const double edge_m = map.consumer->pieceEdge_m();
    if (edge_m < kNarrowestTile_m)
    {
      throw config::ConfigError(fmt::format(
          "--rebuild needs pieces of at least {} m, and {} takes {} m at once: raise its window_m",
          kNarrowestTile_m, map.title(), edge_m));
    }
  }
}

void mapOctree(const Settings& settings, std::vector<BuiltMap>& maps, RunMetrics& metrics)
{
  listMaps(maps, metrics);
  const auto read = [&]
  { return formats::readOctree(formats::readFile(settings.rebuild, formats::kMostOctreeFile)); };
  formats::Octree octree = metrics.times.during("read and decode", [&] { return asInput(read); });
  std::vector<OctreeKey>& leaves = octree.occupied;
  noteCoarseLeaves(octree.resolution_m, maps, metrics);
  const int side = static_cast<int>(narrowestPiece_m(maps) / octree.resolution_m);
  const Tiling tiling{octree.resolution_m, std::max(1, side)};
  std::sort(
      leaves.begin(), leaves.end(),
      [&](OctreeKey a, OctreeKey b) { return tiling.order(a) < tiling.order(b); });
  Progress progress("rebuilding", "tiles", settings.quiet);
  for (size_t first = 0; first < leaves.size() && !Interrupt::exitCode();)
  {
    const auto same_tile = [&](OctreeKey k)
    {
      return tiling.of(k.x) == tiling.of(leaves[first].x) &&
             tiling.of(k.y) == tiling.of(leaves[first].y);
    };
    size_t end = first;
    while (end < leaves.size() && same_tile(leaves[end]))
    {
      ++end;
    }
    insertTile(std::span(leaves).subspan(first, end - first), tiling, settings, maps, metrics);
    first = end;
    progress.show(static_cast<double>(end) / static_cast<double>(leaves.size()), metrics.scans);
  }
  progress.finish(metrics.scans);
  noteLeavesLeftOut(metrics);
}
}  // namespace traverse::app
