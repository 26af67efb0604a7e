// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <support/buffer_scenes.h>
#include <vector>

namespace traverse::testing
{
using Shape = std::function<bool(Place)>;

inline bool isInBox(Place p, double half_x, double half_y)
{
  return std::abs(p.x) <= half_x && std::abs(p.y) <= half_y;
}

struct Named
{
  const char* name;
  Shape shape;
};

inline const std::vector<Named>& singleObstacles()
{
  static const std::vector<Named> kAll = {
      {"cell", [](Place p) { return isInBox(p, 0.6, 0.6); }},
      {"post", [](Place p) { return p.x * p.x + p.y * p.y < 9; }},
      {"box", [](Place p) { return isInBox(p, 20, 12); }},
      {"square", [](Place p) { return isInBox(p, 15, 15); }},
      {"thin wall", [](Place p) { return isInBox(p, 60, 1); }},
      {"disc", [](Place p) { return p.x * p.x + p.y * p.y < 400; }},
      {"large disc", [](Place p) { return p.x * p.x + p.y * p.y < 2500; }},
      {"ellipse", [](Place p) { return p.x * p.x / 900 + p.y * p.y / 100 < 1; }},
      {"L", [](Place p) { return isInBox(p, 30, 30) && (p.x < -22 || p.y < -22); }},
      {"thin L", [](Place p) { return isInBox(p, 30, 30) && (p.x < -28 || p.y < -28); }},
      {"T", [](Place p) { return isInBox(p, 30, 2) || (isInBox(p, 2, 30) && p.y > 0); }},
      {"cross", [](Place p) { return isInBox(p, 30, 3) || isInBox(p, 3, 30); }},
      {"triangle", [](Place p) { return p.y > -20 && p.y < 20 - 1.5 * std::abs(p.x); }},
      {"step", [](Place p) { return isInBox(p, 30, 15) && (p.y < 0 || p.x < 0); }},
      {"obtuse corner",
       [](Place p) { return std::abs(p.x) < 40 && std::abs(p.y + std::abs(p.x) * 0.5) < 2; }},
      {"wave", [](Place p)
       { return std::abs(p.x) < 50 && std::abs(p.y - 4 * geometry::sinCosOf(p.x / 8).sin) < 3; }},
  };
  return kAll;
}
}  // namespace traverse::testing
