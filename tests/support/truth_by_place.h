// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/truth.h>

#include <algorithm>

namespace traverse::testing
{
/** The truth of a scene, asked by place. */
class TruthByPlace
{
 public:
  explicit TruthByPlace(
      const simulation::Scene& scene, double at_s = 0, const Eigen::Vector2d& start = {-3.5, 0.1}) :
      set_(
          simulation::cellTruth(scene, geometry::Vehicle{}, simulation::TruthParams{}, at_s, start))
  {
  }

  const layers::LayerSet& set() const { return set_; }

  simulation::TrueClass of(double x_m, double y_m) const
  {
    return static_cast<simulation::TrueClass>(value<uint8_t>("truth_class", x_m, y_m));
  }

  simulation::TrueState state(double x_m, double y_m) const
  {
    return static_cast<simulation::TrueState>(value<uint8_t>("truth_state", x_m, y_m));
  }

  float number(const char* layer, double x_m, double y_m) const
  {
    return value<float>(layer, x_m, y_m);
  }

  uint32_t object(double x_m, double y_m) const
  {
    return value<uint32_t>("truth_object", x_m, y_m);
  }

  simulation::Label label(double x_m, double y_m) const
  {
    return static_cast<simulation::Label>(value<uint8_t>("truth_label", x_m, y_m));
  }

  /** True where all cells are of this class. */
  bool all(simulation::TrueClass of) const
  {
    const auto& codes = std::get<std::vector<uint8_t>>(set_.find("truth_class")->data);
    return std::all_of(
        codes.begin(), codes.end(), [&](uint8_t c) { return c == static_cast<uint8_t>(of); });
  }

 private:
  template <class T>
  T value(const char* layer, double x_m, double y_m) const
  {
    const geometry::CellIndex c =
        set_.lattice.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
    const auto& cells = std::get<std::vector<T>>(set_.find(layer)->data);
    return cells.at(
        static_cast<size_t>(c.y - set_.extent.min.y) * static_cast<size_t>(set_.extent.width()) +
        static_cast<size_t>(c.x - set_.extent.min.x));
  }

  layers::LayerSet set_;
};
}  // namespace traverse::testing
