// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>
#include <traverse/plugin/map_shell.h>

#include <map>
#include <string>
#include <vector>

namespace traverse::maps
{
/** How the map is drawn; section renderOpts. */
struct MultiLidarRenderParams
{
  bool show_unknown = true;
  bool show_points = true;
  bool show_axes = true;

  friend bool operator==(const MultiLidarRenderParams&, const MultiLidarRenderParams&) = default;
};

template <class P, class F>
void visitMultiLidarRenderParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"show_unknown", "draws cells that nobody saw, in dark grey"}, p.show_unknown);
  f(Option{"show_points", "draws the latest cloud of each lidar in a colour of its own"},
    p.show_points);
  f(Option{"show_axes", "draws the robot's axes"}, p.show_axes);
}

template <class F>
void visit(MultiLidarRenderParams& p, F&& f)
{
  visitMultiLidarRenderParams(p, f);
}

template <class F>
void visit(const MultiLidarRenderParams& p, F&& f)
{
  visitMultiLidarRenderParams(p, f);
}

/** Occupancy from several lidars that nothing synchronises, on a torus that follows the robot:
 * traverse/multi_lidar_grid, as an MRPT map.
 *
 * Made from an ini by `CWrappableMultiLidarGrid_count = 1` (or wrappableMultiLidarGrid_count) with
 * the sections <prefix>_insertOpts, _likelihoodOpts, _renderOpts and _creationOpts, and the
 * sections [Vehicle] and [Sensors], which all maps of the file share. All are read strictly: an
 * unknown key or a value that is not allowed throws config::ConfigError.
 *
 * insertionOptions and vehicle may be changed in place while the map is empty. */
class CWrappableMultiLidarGrid : public MapShell
{
  DEFINE_SERIALIZABLE(CWrappableMultiLidarGrid, traverse::maps)

 public:
  CWrappableMultiLidarGrid() :
      CWrappableMultiLidarGrid(multi_lidar_grid::Params{}, geometry::Vehicle{})
  {
  }

  /** Throws options::OptionError where they contradict each other. */
  CWrappableMultiLidarGrid(const multi_lidar_grid::Params& params, const geometry::Vehicle& of);

  multi_lidar_grid::Params insertionOptions;
  geometry::Vehicle vehicle;
  multi_lidar_grid::LikelihoodParams likelihoodOptions;
  MultiLidarRenderParams renderOptions;

  // layers::ScanConsumer
  /** Throws std::invalid_argument where the map has clouds and options of other values made it. */
  layers::UpdateStats insertScan(const points::Scan& scan, const poses::PoseTrack& track) override;
  void advance(poses::TimeNs now) override;
  layers::LayerSet layerSet(
      std::optional<geometry::CellRect> window = std::nullopt,
      const layers::LayerChoice& wanted = {}) const override;
  std::string archive() const override;

  std::string_view archiveKind() const override { return multi_lidar_grid::kArchiveKind; }

  /** Replaces options, vehicle and cells; what sensors saw last is not in archives. */
  void setFromArchive(std::string_view bytes) override;
  void mergeArchive(std::string_view bytes) override;  //!< throws std::invalid_argument
  std::string mergeObstacle() const override;
  std::vector<layers::Fact> explain(double x_m, double y_m) const override;

  /** The occupancy as a .gridmap of MRPT's COccupancyGridMap2D; within 100 km of map zero, as its
   * coordinates are floats. */
  std::vector<layers::ExtraFile> extraFiles() const override;
  std::vector<std::string> warnings() const override;
  double pieceEdge_m() const override;

  const multi_lidar_grid::State& state() const { return state_; }

  // mrpt::maps::CMetricMap
  bool isEmpty() const override;
  std::string asString() const override;
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const override;

  MAP_DEFINITION_START(CWrappableMultiLidarGrid)
  multi_lidar_grid::Params insertionOpts;
  multi_lidar_grid::LikelihoodParams likelihoodOpts;
  MultiLidarRenderParams render_opts;
  geometry::Vehicle vehicle;
  observations::ObservationParams sensors;
  MAP_DEFINITION_END(CWrappableMultiLidarGrid)

 private:
  /** The occupancy as <prefix>.pgm and .yaml. */
  void saveMore(const std::string& prefix, const layers::LayerSet& set) const override;

  /** A cloud to be drawn. */
  struct LatestPoints
  {
    Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
    std::vector<float> x, y, z;
  };

  void internal_clear() override;
  void adoptOptions();
  double logLikelihoodOf(
      const points::Scan& scan, const Eigen::Isometry3d& T_map_base) const override;
  void drawPoints(mrpt::opengl::CSetOfObjects& scene) const;

  multi_lidar_grid::Params made_with_;
  geometry::Vehicle made_for_;
  multi_lidar_grid::State state_;
  std::map<std::string, LatestPoints, std::less<>> latest_points_;  // by sensor label
};
}  // namespace traverse::maps
