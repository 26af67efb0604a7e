// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "embree_scene.h"

namespace traverse::simulation
{
SurfaceSoup::Vertex SurfaceSoup::vertexAt(const Eigen::Vector3d& p_map) const
{
  const Eigen::Vector3f p = (p_map - origin_).cast<float>();
  return {p.x(), p.y(), p.z()};
}

void SurfaceSoup::add(const Object& object, uint32_t number, const Eigen::Isometry3d& T_map_body)
{
  checkTriangles(object);
  for (const Part& part : object.parts)
  {
    const auto first = static_cast<uint32_t>(vertices_.size());
    triangle_runs_.push_back(
        {static_cast<uint32_t>(triangles_.size()), number, object.label, part.material});
    for (const Eigen::Vector3f& v : part.vertices)
    {
      vertices_.push_back(vertexAt(T_map_body * v.cast<double>()));
    }
    for (const auto& [a, b, c] : part.triangles)
    {
      triangles_.push_back({first + a, first + b, first + c});
    }
  }
  for (const Ball& ball : object.balls)
  {
    ball_runs_.push_back(
        {static_cast<uint32_t>(balls_.size()), number, object.label, ball.material});
    const Vertex centre = vertexAt(T_map_body * ball.centre.cast<double>());
    balls_.push_back({centre[0], centre[1], centre[2], ball.radius_m});
  }
}

void SurfaceSoup::add(const Terrain& terrain, const Area& area, uint32_t columns, uint32_t rows)
{
  grids_.push_back({static_cast<uint32_t>(grid_vertices_.size()), columns, rows});
  for (uint32_t row = 0; row < rows; ++row)
  {
    // The last one is the border to the bit, so that the next tile begins where this one ends.
    const double y = row + 1 == rows
                         ? area.max_y_m
                         : area.min_y_m + (area.max_y_m - area.min_y_m) * row / (rows - 1);
    for (uint32_t column = 0; column < columns; ++column)
    {
      const double x = column + 1 == columns
                           ? area.max_x_m
                           : area.min_x_m + (area.max_x_m - area.min_x_m) * column / (columns - 1);
      grid_vertices_.push_back(vertexAt({x, y, terrain.at(x, y).height_m}));
    }
  }
}
}  // namespace traverse::simulation
