// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/maps/CWrappableMultiLidarGrid.h>

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace traverse::maps
{
namespace
{
const multi_lidar_grid::Params& checked(
    const multi_lidar_grid::Params& params, const geometry::Vehicle& vehicle)
{
  multi_lidar_grid::check(params, vehicle);
  return params;
}
}  // namespace

CWrappableMultiLidarGrid::CWrappableMultiLidarGrid(
    const multi_lidar_grid::Params& params, const geometry::Vehicle& of) :
    insertionOptions(params),
    vehicle(of),
    made_with_(params),
    made_for_(of),
    state_(checked(params, of), of)
{
}

void CWrappableMultiLidarGrid::adoptOptions()
{
  if (insertionOptions == made_with_ && vehicle == made_for_)
  {
    return;
  }
  if (!state_.empty())
  {
    throw std::invalid_argument(
        "CWrappableMultiLidarGrid: options may be changed in place only while the map is empty");
  }
  internal_clear();
}

layers::UpdateStats CWrappableMultiLidarGrid::insertScan(
    const points::Scan& scan, const poses::PoseTrack& track)
{
  adoptOptions();
  const layers::UpdateStats stats =
      multi_lidar_grid::update(state_, scan, track, made_with_, made_for_);
  const std::optional<poses::TrackedPose> pose = track.at(scan.stamp);
  if (renderOptions.show_points && stats.inserted && pose)
  {
    constexpr size_t kMostDrawn = multi_lidar_grid::Sensors::kMost;
    auto found = latest_points_.find(scan.sensor_label);
    if (found == latest_points_.end() && latest_points_.size() < kMostDrawn)
    {
      found = latest_points_.emplace(std::string(scan.sensor_label), LatestPoints{}).first;
    }
    if (found != latest_points_.end())
    {
      LatestPoints& latest = found->second;
      latest.T_map_base = pose->T_map_base;
      latest.x.assign(scan.x.begin(), scan.x.end());
      latest.y.assign(scan.y.begin(), scan.y.end());
      latest.z.assign(scan.z.begin(), scan.z.end());
    }
  }
  return stats;
}

void CWrappableMultiLidarGrid::advance(poses::TimeNs now)
{
  multi_lidar_grid::advance(state_, now, made_with_);
}

layers::LayerSet CWrappableMultiLidarGrid::layerSet(
    std::optional<geometry::CellRect> window, const layers::LayerChoice& wanted) const
{
  return multi_lidar_grid::layerSet(state_, made_with_, made_for_, window, wanted);
}

std::string CWrappableMultiLidarGrid::archive() const
{
  return multi_lidar_grid::archive(state_, made_with_, made_for_);
}

void CWrappableMultiLidarGrid::setFromArchive(std::string_view bytes)
{
  multi_lidar_grid::Map map = multi_lidar_grid::fromArchive(bytes);
  insertionOptions = made_with_ = std::move(map.params);
  vehicle = made_for_ = std::move(map.vehicle);
  state_ = std::move(map.state);
  latest_points_.clear();
}

void CWrappableMultiLidarGrid::mergeArchive(std::string_view /*bytes*/)
{
  throw std::invalid_argument(mergeObstacle());
}

std::string CWrappableMultiLidarGrid::mergeObstacle() const
{
  return "CWrappableMultiLidarGrid: what a cell is depends on the order of the clouds, which maps "
         "of pieces of a log do not know of each other; map the whole log in one run";
}

std::vector<layers::Fact> CWrappableMultiLidarGrid::explain(double x_m, double y_m) const
{
  const geometry::CellIndex cell =
      state_.lattice.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
  return multi_lidar_grid::explain(state_, made_with_, made_for_, cell);
}

double CWrappableMultiLidarGrid::pieceEdge_m() const
{
  constexpr double kRounded = 3;  // cells: the region is whole cells around the pose's
  return std::max(0.0, insertionOptions.window_m - kRounded * insertionOptions.cell_size_m);
}

bool CWrappableMultiLidarGrid::isEmpty() const
{
  return state_.empty();
}

std::string CWrappableMultiLidarGrid::asString() const
{
  const int32_t edge = state_.cells.region().width();
  return fmt::format(
      "Wrappable multi-lidar grid: {} x {} cells of {} m, {} sensors", edge, edge,
      state_.lattice.cell_m(), state_.sensors.all().size());
}

void CWrappableMultiLidarGrid::internal_clear()
{
  state_ = multi_lidar_grid::State(checked(insertionOptions, vehicle), vehicle);
  made_with_ = insertionOptions;
  made_for_ = vehicle;
  latest_points_.clear();
}

double CWrappableMultiLidarGrid::logLikelihoodOf(
    const points::Scan& scan, const Eigen::Isometry3d& T_map_base) const
{
  return multi_lidar_grid::logLikelihood(
      state_, scan, T_map_base, made_with_, made_for_, likelihoodOptions);
}
}  // namespace traverse::maps
