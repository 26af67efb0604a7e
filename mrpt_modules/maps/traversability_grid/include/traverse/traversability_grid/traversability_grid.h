// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/points/scan.h>
#include <traverse/traversability_grid/state.h>

#include <Eigen/Geometry>

#include <optional>
#include <string>
#include <string_view>

// The classification of a robot's workspace by statistics of grid cells (paper 3).
namespace traverse::traversability_grid
{
/** Adds a deskewed scan taken at T_map_base and classifies the cells that it touched.
 *
 * All of the scan or nothing. Points that are not finite or absurdly far are skipped and counted; a
 * pose that is not finite or beyond the lattice skips the scan. Throws std::invalid_argument where
 * the map has points and cell_size_m or the slab height are no longer those it was made with. */
layers::UpdateStats update(
    State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params,
    const geometry::Vehicle& vehicle);

/** Lets go of what is older than forget_after_s at a time, where the map forgets. update() does it
 * by its scans' stamps; call it where no scan comes any more. */
void advance(State& state, poses::TimeNs now, const Params& params);

/** The map's layers in a window. By default all of it: a rolling map's window, a fixed map's
 * rectangle, a growing map's occupied cells (no cells where there is none).
 *
 * Classes and ground heights in a window are those that update() found last for each cell, from the
 * cells of one scan; without a window they are made new from all cells, so that they depend on the
 * sums only and on no order.
 *
 * Throws std::length_error for more than kMostLayerCells. */
layers::LayerSet layerSet(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    std::optional<geometry::CellRect> window = std::nullopt);

inline constexpr int64_t kMostLayerCells = 100'000'000;

/** Cells that layerSet() shows by default. */
geometry::CellRect extentOf(const State& state, const Params& params);

inline constexpr std::string_view kArchiveKind = "traversability_grid";
inline constexpr uint32_t kArchiveVersion = 2;

/** A map with the options that made it. */
struct Map
{
  Params params;
  geometry::Vehicle vehicle;
  State state;
};

/** Checked, versioned bytes of options and sums. The same points give the same bytes in whatever
 * order they came; what is not of the points (classes, the robot) is not in it. */
std::string archive(const State& state, const Params& params, const geometry::Vehicle& vehicle);

/** Takes any bytes; throws formats::FormatError where they are no archive of this map, are damaged,
 * newer than this program, or contradict themselves. */
Map fromArchive(std::string_view bytes);

/** Why maps of pieces of a log with these options do not merge to the map of the whole log: they
 * forget by the order of the scans. Empty where they do. */
std::string mergeObstacle(const Params& params);

/** Adds another map's sums: afterwards `state` is the map of both maps' points, to the last bit
 * (archive()), and classified as such.
 *
 * All or nothing. Throws std::invalid_argument where the other has other options or another
 * vehicle, or for mergeObstacle(), and std::length_error beyond max_memory_mb. */
void merge(State& state, const Params& params, const geometry::Vehicle& vehicle, const Map& other);

/** How points are held against the map; section likelihoodOpts. */
struct LikelihoodParams
{
  double sigma_m = 0.1;
  double worst = 3;
  int max_points = 300;

  friend bool operator==(const LikelihoodParams&, const LikelihoodParams&) = default;
};

/** Log-likelihood of a scan at a pose: the sum over evenly picked points of -min(d^2 / (2 sigma^2),
 * worst), d being the point's vertical distance from the heights of its cell's nearest slab, and of
 * -worst in a cell that was never seen. 0 for an empty map, an empty scan or a pose that is none.
 */
double logLikelihood(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const LikelihoodParams& params);

template <class P, class F>
void visitLikelihoodParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"sigma_m", "standard deviation of a point's height against the map, m", {0.001, 100}},
    p.sigma_m);
  f(Option{"worst", "a point lowers the log-likelihood by this at most", {0.01, 1000}}, p.worst);
  f(Option{"max_points", "so many points of a scan are looked at, evenly picked", {1, 1000000}},
    p.max_points);
}

template <class F>
void visit(LikelihoodParams& p, F&& f)
{
  visitLikelihoodParams(p, f);
}

template <class F>
void visit(const LikelihoodParams& p, F&& f)
{
  visitLikelihoodParams(p, f);
}
}  // namespace traverse::traversability_grid
