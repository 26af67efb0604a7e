// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/point_octree.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/plugin/map_shell.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <string>

namespace traverse::maps
{
/** How the map is drawn; section renderOpts. */
struct TraversabilityRenderParams
{
  bool show_undefined = true;
  bool show_axes = true;

  friend bool operator==(const TraversabilityRenderParams&, const TraversabilityRenderParams&) =
      default;
};

template <class P, class F>
void visitRenderParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"show_undefined", "draws cells of undefined class that have points, in grey"},
    p.show_undefined);
  f(Option{"show_axes", "draws the robot's axes"}, p.show_axes);
}

template <class F>
void visit(TraversabilityRenderParams& p, F&& f)
{
  visitRenderParams(p, f);
}

template <class F>
void visit(const TraversabilityRenderParams& p, F&& f)
{
  visitRenderParams(p, f);
}

/** A grid of the workspace whose cells are flat, roughness, or obstacle by statistics of the points
 * that fall on them: traverse/traversability_grid, as an MRPT map.
 *
 * Made from an ini by `CTraversabilityGridMap_count = 1` (or traversabilityGridMap_count) with the
 * sections <prefix>_insertOpts, _likelihoodOpts, _renderOpts, _octomapOpts and _creationOpts, and
 * the sections [Vehicle] and [Sensors], which all maps of the file share. All are read strictly: an
 * unknown key or a value that is not allowed throws config::ConfigError.
 *
 * Options may be changed in place; those that the cells' sums depend on (cell_size_m,
 * slab_height_m) and the octree's resolution only while the map is empty. */
class CTraversabilityGridMap : public MapShell
{
  DEFINE_SERIALIZABLE(CTraversabilityGridMap, traverse::maps)

 public:
  CTraversabilityGridMap() = default;

  traversability_grid::Params insertionOptions;
  traversability_grid::LikelihoodParams likelihoodOptions;
  TraversabilityRenderParams renderOptions;
  formats::OctomapParams octomapOptions;
  geometry::Vehicle vehicle;

  // layers::ScanConsumer
  layers::UpdateStats insertScan(const points::Scan& scan, const poses::PoseTrack& track) override;
  void advance(poses::TimeNs now) override;
  std::vector<uint32_t> pointLabels(
      const points::Scan& scan, const poses::PoseTrack& track) const override;
  layers::LayerSet layerSet(
      std::optional<geometry::CellRect> window = std::nullopt,
      const layers::LayerChoice& wanted = {}) const override;
  std::string archive() const override;
  void mergeArchive(std::string_view bytes) override;
  std::string mergeObstacle() const override;

  std::string_view archiveKind() const override { return traversability_grid::kArchiveKind; }

  std::vector<layers::Fact> explain(double x_m, double y_m) const override;
  std::vector<layers::ExtraFile> extraFiles() const override;  //!< the octree, where there is one
  std::string mergedEnding() const override;
  void mergeExtra(std::string_view bytes) override;
  std::vector<std::string> warnings() const override;
  double pieceEdge_m() const override;

  /** Replaces options, vehicle and cells by those of archive(); the octree, which is not in it, is
   * empty then. Throws formats::FormatError, with the map as it was. */
  void setFromArchive(std::string_view bytes) override;

  const traversability_grid::State& state() const { return state_; }

  // mrpt::maps::CMetricMap
  bool isEmpty() const override;
  std::string asString() const override;
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& scene) const override;

  MAP_DEFINITION_START(CTraversabilityGridMap)
  traversability_grid::Params insertionOpts;
  traversability_grid::LikelihoodParams likelihoodOpts;
  TraversabilityRenderParams render_opts;
  formats::OctomapParams octomap_opts;
  geometry::Vehicle vehicle;
  observations::ObservationParams sensors;
  MAP_DEFINITION_END(CTraversabilityGridMap)

 private:
  void internal_clear() override;
  double logLikelihoodOf(
      const points::Scan& scan, const Eigen::Isometry3d& T_map_base) const override;

  traversability_grid::State state_;
  formats::PointOctree octree_;  // of every scan with a pose, whatever the cells take or forget
};
}  // namespace traverse::maps
