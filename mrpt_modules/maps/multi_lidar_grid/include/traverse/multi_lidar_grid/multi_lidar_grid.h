// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/multi_lidar_grid/state.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Toroidal occupancy from several lidars that nothing synchronises (paper 5).
namespace traverse::multi_lidar_grid
{
/** Adds one sensor's deskewed cloud: its unit map, made with the pose at the cloud's own time, into
 * the accumulated map. Never waits for another sensor. Clouds that come later than order_window_s
 * behind the newest are refused and counted with the sensor.
 *
 * All of the cloud or nothing. Points that are not finite are skipped and counted; a scan without a
 * valid pose is skipped. `params` and `vehicle` must be those of the state's making. */
layers::UpdateStats update(
    State& state,
    const points::Scan& scan,
    const poses::PoseTrack& track,
    const Params& params,
    const geometry::Vehicle& vehicle);

/** Time goes on without a cloud: sensors time out, and what is older than forget_after_s goes. */
void advance(State& state, poses::TimeNs now, const Params& params);

/** Obstacle over negative over overhang over free over unknown: which of two sensors' words counts.
 */
layers::OccupancyState stronger(layers::OccupancyState a, layers::OccupancyState b);

/** The map's layers in a window (by default the region, no cells where the map is empty); cells
 * outside the region are unknown. Of the accumulated map: occupancy_state (layers::OccupancyState),
 * sensor_mask (which sensors said so, a bit each), free_height (m, known free up to here over the
 * ground; NaN where not free), ground_height (m), last_seen_age (s; NaN where unknown),
 * safety_buffer (layers::BufferZone). Of the latest cloud of each sensor that is not silent:
 * occupancy_latest and latest_mask. For pictures, the class layer: occupancy_view, which is
 * occupancy_state but 5 where several sensors saw a free cell. safety_buffer and those of latest
 * clouds, which take most of the time, only where they are wanted.
 *
 * Throws std::length_error for more than kMostLayerCells. */
layers::LayerSet layerSet(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    std::optional<geometry::CellRect> window = std::nullopt,
    const layers::LayerChoice& wanted = {});

inline constexpr int64_t kMostLayerCells = 100'000'000;

inline constexpr std::string_view kArchiveKind = "multi_lidar_grid";
inline constexpr uint32_t kArchiveVersion = 1;

/** A map with the options that made it. */
struct Map
{
  Params params;
  geometry::Vehicle vehicle;
  State state;
};

/** Checked, versioned bytes of options, accumulated cells and sensors; without the latest clouds,
 * which are gone with their time. */
std::string archive(const State& state, const Params& params, const geometry::Vehicle& vehicle);

/** Takes any bytes; throws formats::FormatError where they are no archive of this map, are damaged,
 * newer than this program, or contradict themselves. */
Map fromArchive(std::string_view bytes);

/** Why a cell is what it is: key and value. */
std::vector<layers::Fact> explain(
    const State& state,
    const Params& params,
    const geometry::Vehicle& vehicle,
    geometry::CellIndex cell);

/** How scans are held against the map; section likelihoodOpts. */
struct LikelihoodParams
{
  double sigma_m = 0.3;
  double worst = 3;
  int max_points = 300;

  friend bool operator==(const LikelihoodParams&, const LikelihoodParams&) = default;
};

/** Log-likelihood of a scan at a pose: the sum over evenly picked obstacle points (higher than
 * obstacle_height_m over the ground, lower than the vehicle) of -min(d^2 / (2 sigma^2), worst), d
 * being the distance to the nearest obstacle cell. 0 for an empty map, an empty scan or a pose that
 * is none. */
double logLikelihood(
    const State& state,
    const points::Scan& scan,
    const Eigen::Isometry3d& T_map_base,
    const Params& params,
    const geometry::Vehicle& vehicle,
    const LikelihoodParams& likelihood);

template <class P, class F>
void visitLikelihoodParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"sigma_m", "standard deviation of a point's distance from an obstacle, m", {0.001, 100}},
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
}  // namespace traverse::multi_lidar_grid
