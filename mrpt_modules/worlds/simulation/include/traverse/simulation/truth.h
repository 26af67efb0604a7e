// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/vehicle.h>
#include <traverse/layers/layer_set.h>
#include <traverse/options/option.h>
#include <traverse/simulation/scene.h>

#include <Eigen/Core>

#include <cstdint>

namespace traverse::simulation
{
/** How cells are judged from the surfaces of a scene: section [Truth]. */
struct TruthParams
{
  double cell_size_m = 0.2;
  double flat_max_m = 0.03;
  double small_max_m = 0.10;
  double large_max_m = 0.25;

  friend bool operator==(const TruthParams&, const TruthParams&) = default;
};

template <class P, class F>
void visitTruthParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"cell_size_m", "edge of a cell of the truth, m, whole millimetres", {0.02, 10}},
    p.cell_size_m);
  f(Option{"flat_max_m", "a cell of less roughness is flat, m", {0.001, 5}}, p.flat_max_m);
  f(Option{"small_max_m", "a cell of less roughness has small roughness, m", {0.001, 5}},
    p.small_max_m);
  f(
      Option{
          "large_max_m",
          "a cell of less roughness has large roughness, one of more is an obstacle, m",
          {0.001, 5}},
      p.large_max_m);
}

template <class F>
void visit(TruthParams& p, F&& f)
{
  visitTruthParams(p, f);
}

template <class F>
void visit(const TruthParams& p, F&& f)
{
  visitTruthParams(p, f);
}

/** What a cell is in truth; the codes of the layer truth_class. */
enum class TrueClass : uint8_t
{
  unknown = 0,  //!< no ground there
  flat = 1,
  small_roughness = 2,
  large_roughness = 3,
  obstacle = 4,
};

/** What can be done with a cell in truth; the codes of the layer truth_state. */
enum class TrueState : uint8_t
{
  unknown = 0,
  free = 1,
  occupied = 2,  //!< an obstacle, or ground that cannot be reached
  overhang = 3,  //!< free, and something hangs above the vehicle's height
  ditch = 4,     //!< the ground falls away by more than the large limit
};

/** Largest extent that can be judged. */
inline constexpr int64_t kMostTruthCells = 4'000'000;

/** Throws what cellTruth() would, but for triangles: to be known before anything is simulated. */
void checkTruth(const Scene& scene, const TruthParams& params, const Eigen::Vector2d& start);

/** Judges every whole cell of the scene's area, with things where they are at at_s, seconds after
 * the scene's beginning; `start` is a place that the vehicle comes from, m (doc/simulation.md says
 * how a cell is judged). The same bits on every machine.
 *
 * Layers: truth_class, truth_state (codes above), truth_roughness, truth_step (m), truth_slope
 * (deg), ground_height (m, of the smooth ground that the vehicle comes from), truth_object (number
 * of the thing that decides, 1: the ground), truth_label (its Label).
 *
 * Throws options::OptionError for limits out of order or range, std::invalid_argument for a scene
 * without ground, a start outside its area, or a triangle of vertices that are not there,
 * std::length_error for more than kMostTruthCells. */
layers::LayerSet cellTruth(
    const Scene& scene,
    const geometry::Vehicle& vehicle,
    const TruthParams& params,
    double at_s,
    const Eigen::Vector2d& start);
}  // namespace traverse::simulation
