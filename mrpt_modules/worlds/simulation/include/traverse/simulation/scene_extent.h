// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene_choices.h>

#include <concepts>
#include <string>
#include <type_traits>

namespace traverse::simulation
{
/** Section [Scene]: how far the ground goes, and what it is where no [Terrain_NN] says more. */
struct SceneExtentParams
{
  std::string title;
  double min_x_m = -50;
  double min_y_m = -50;
  double max_x_m = 50;
  double max_y_m = 50;
  MaterialChoice ground_material = MaterialChoice::usual;
  LabelChoice ground_label = LabelChoice::usual;

  friend bool operator==(const SceneExtentParams&, const SceneExtentParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, SceneExtentParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"title", "name of the scene in reports"}, p.title);
  f(Option{"min_x_m", "western end of the ground, m", {-2000, 2000}}, p.min_x_m);
  f(Option{"min_y_m", "southern end of the ground, m", {-2000, 2000}}, p.min_y_m);
  f(Option{"max_x_m", "eastern end of the ground, m", {-2000, 2000}}, p.max_x_m);
  f(Option{"max_y_m", "northern end of the ground, m", {-2000, 2000}}, p.max_y_m);
  f(Option{"ground_material", "of the ground where no terrain says more; usual: soil"},
    p.ground_material);
  f(Option{"ground_label", "of the ground where no terrain says more; usual: ground"},
    p.ground_label);
}
}  // namespace traverse::simulation
