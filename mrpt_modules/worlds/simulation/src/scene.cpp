// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/scene.h>

#include <algorithm>
#include <stdexcept>

namespace traverse::simulation
{
void checkTriangles(const Object& object)
{
  for (const Part& part : object.parts)
  {
    const size_t vertices = part.vertices.size();
    const bool all_there = std::all_of(
        part.triangles.begin(), part.triangles.end(),
        [vertices](const auto& t) {
          return std::max({t[0], t[1], t[2]}) < vertices;
        });
    if (!all_there)
    {
      throw std::invalid_argument(object.name + " has a triangle without its vertices");
    }
  }
}
}  // namespace traverse::simulation
