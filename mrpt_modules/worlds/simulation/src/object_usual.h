// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/object_params.h>

#include <array>

namespace traverse::simulation
{
/** What a kind of object has where the scene file says nothing. */
struct UsualObject
{
  ObjectKind kind = ObjectKind::box;
  Label label = Label::thing;
  Material material = Material::concrete;
  double length_m = 1;
  double width_m = 1;
  double height_m = 1;
  double radius_m = 0.5;
  double branch_height_m = 0;
  int count = 0;
};

inline constexpr std::array<UsualObject, 18> kUsualObjects = {{
    {ObjectKind::box, Label::thing, Material::wood, 1, 1, 1, 0, 0, 0},
    {ObjectKind::prism, Label::thing, Material::concrete, 1, 1, 1, 0, 0, 0},
    {ObjectKind::cylinder, Label::thing, Material::concrete, 0, 0, 1, 0.5, 0, 0},
    {ObjectKind::hemisphere, Label::thing, Material::concrete, 0, 0, 0, 0.5, 0, 0},
    {ObjectKind::wall, Label::wall, Material::brick, 8, 0.25, 2, 0, 0, 0},
    {ObjectKind::building, Label::building, Material::brick, 12, 8, 6, 0, 0, 0},
    {ObjectKind::fence_wire, Label::fence, Material::metal, 12, 0.004, 1.2, 0.03, 0, 0},
    {ObjectKind::fence_board, Label::fence, Material::wood, 12, 0.02, 1.5, 0.05, 0, 0},
    {ObjectKind::grass, Label::grass, Material::grass, 4, 4, 0.3, 0, 0, 300},
    {ObjectKind::lumps, Label::lump, Material::snow, 4, 4, 0.08, 0.15, 0, 60},
    {ObjectKind::bush, Label::bush, Material::foliage, 0, 1.4, 1.3, 0, 0, 900},
    {ObjectKind::tree, Label::tree, Material::wood, 0, 4, 7, 0.16, 2.6, 900},
    {ObjectKind::pole, Label::pole, Material::metal, 0, 0, 4, 0.06, 0, 0},
    {ObjectKind::vehicle, Label::vehicle, Material::metal, 4.3, 1.8, 1.5, 0, 0, 0},
    {ObjectKind::person, Label::person, Material::cloth, 0, 0, 1.75, 0, 0, 0},
    {ObjectKind::bridge, Label::structure, Material::concrete, 10, 5, 3.5, 0, 0, 0},
    {ObjectKind::gate, Label::structure, Material::metal, 0, 4, 3, 0.08, 0, 0},
    {ObjectKind::table, Label::structure, Material::wood, 1.6, 0.8, 0.75, 0, 0, 0},
}};
}  // namespace traverse::simulation
