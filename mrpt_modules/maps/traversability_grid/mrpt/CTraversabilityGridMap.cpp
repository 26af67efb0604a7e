// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/traversability_grid/explain.h>
#include <traverse/traversability_grid/point_labels.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::maps
{
layers::UpdateStats CTraversabilityGridMap::insertScan(
    const points::Scan& scan, const poses::PoseTrack& track)
{
  const std::optional<poses::TrackedPose> pose = track.at(scan.stamp);
  if (!pose)
  {
    layers::UpdateStats skipped;
    skipped.no_pose = true;
    return skipped;
  }
  octree_.adopt(octomapOptions);
  layers::UpdateStats stats =
      traversability_grid::update(state_, scan, pose->T_map_base, insertionOptions, vehicle);
  if (!stats.no_pose)
  {
    const uint64_t lost = octree_.counts().over_budget;
    octree_.insert(scan, pose->T_map_base);
    stats.over_budget += octree_.counts().over_budget - lost;
  }
  return stats;
}

void CTraversabilityGridMap::advance(poses::TimeNs now)
{
  traversability_grid::advance(state_, now, insertionOptions);
}

std::vector<uint32_t> CTraversabilityGridMap::pointLabels(
    const points::Scan& scan, const poses::PoseTrack& track) const
{
  const std::optional<poses::TrackedPose> pose = track.at(scan.stamp);
  if (!pose)
  {
    return std::vector<uint32_t>(scan.size(), 0);
  }
  const std::vector<traversability_grid::PointLabel> labels =
      traversability_grid::labelsOfLastScan(state_, scan, pose->T_map_base, insertionOptions);
  std::vector<uint32_t> codes(labels.size());
  std::transform(
      labels.begin(), labels.end(), codes.begin(),
      [](traversability_grid::PointLabel label) { return static_cast<uint32_t>(label); });
  return codes;
}

layers::LayerSet CTraversabilityGridMap::layerSet(
    std::optional<geometry::CellRect> window, const layers::LayerChoice& /*wanted*/) const
{
  return traversability_grid::layerSet(state_, insertionOptions, vehicle, window);
}

std::string CTraversabilityGridMap::archive() const
{
  return traversability_grid::archive(state_, insertionOptions, vehicle);
}

void CTraversabilityGridMap::mergeArchive(std::string_view bytes)
{
  traversability_grid::merge(
      state_, insertionOptions, vehicle, traversability_grid::fromArchive(bytes));
}

std::string CTraversabilityGridMap::mergeObstacle() const
{
  return traversability_grid::mergeObstacle(insertionOptions);
}

std::vector<layers::Fact> CTraversabilityGridMap::explain(double x_m, double y_m) const
{
  const geometry::CellIndex cell =
      state_.lattice.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
  return traversability_grid::explain(state_, insertionOptions, vehicle, cell);
}

std::vector<layers::ExtraFile> CTraversabilityGridMap::extraFiles() const
{
  return octree_.files();
}

std::string CTraversabilityGridMap::mergedEnding() const
{
  return octomapOptions.resolution_m > 0 ? ".bt" : "";
}

void CTraversabilityGridMap::mergeExtra(std::string_view bytes)
{
  octree_.adopt(octomapOptions);
  octree_.merge(bytes);
}

std::vector<std::string> CTraversabilityGridMap::warnings() const
{
  return octree_.warnings();
}

double CTraversabilityGridMap::pieceEdge_m() const
{
  constexpr double kRounded = 3;  // cells: the window is whole cells around the pose's
  return std::max(0.0, insertionOptions.window_m - kRounded * insertionOptions.cell_size_m);
}

void CTraversabilityGridMap::setFromArchive(std::string_view bytes)
{
  traversability_grid::Map map = traversability_grid::fromArchive(bytes);
  formats::PointOctree empty_octree(octomapOptions);
  insertionOptions = map.params;
  vehicle = std::move(map.vehicle);
  state_ = std::move(map.state);
  octree_ = std::move(empty_octree);
}

bool CTraversabilityGridMap::isEmpty() const
{
  return state_.empty();
}

std::string CTraversabilityGridMap::asString() const
{
  return fmt::format(
      "Traversability grid: {} cells of {} m with points, {} height slabs", state_.occupied,
      state_.lattice.cell_m(), state_.slabs.size());
}

void CTraversabilityGridMap::internal_clear()
{
  state_ = traversability_grid::makeState(insertionOptions, vehicle);
  octree_ = formats::PointOctree(octomapOptions);
}

double CTraversabilityGridMap::logLikelihoodOf(
    const points::Scan& scan, const Eigen::Isometry3d& T_map_base) const
{
  return traversability_grid::logLikelihood(state_, scan, T_map_base, likelihoodOptions);
}
}  // namespace traverse::maps
