// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_cells.h"
#include "truth_grid.h"
#include "truth_limits.h"
#include "truth_pieces.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/truth.h>

#include <stdexcept>

namespace traverse::simulation
{
namespace
{
void checkScene(const Scene& scene, const Eigen::Vector2d& start)
{
  if (!scene.terrain)
  {
    throw std::invalid_argument("a scene without ground has no truth");
  }
  const Area& area = scene.area;
  if (!(start.x() >= area.min_x_m && start.x() <= area.max_x_m && start.y() >= area.min_y_m &&
        start.y() <= area.max_y_m))
  {
    throw std::invalid_argument("the start does not lie in the scene's area");
  }
}

Pieces piecesOf(const Scene& scene, const SubGrid& grid, double at_s)
{
  Pieces pieces(grid);
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    pieces.add(scene.objects[i], Scene::kFirstObject + static_cast<uint32_t>(i), at_s);
  }
  return pieces;
}
}  // namespace

void checkTruth(const Scene& scene, const TruthParams& params, const Eigen::Vector2d& start)
{
  const int32_t cell_mm = checkedCell_mm(params);
  checkScene(scene, start);
  subGridOf(scene.area, cell_mm);
}

layers::LayerSet cellTruth(
    const Scene& scene,
    const geometry::Vehicle& vehicle,
    const TruthParams& params,
    double at_s,
    const Eigen::Vector2d& start)
{
  const int32_t cell_mm = checkedCell_mm(params);
  checkScene(scene, start);
  const SubGrid grid = subGridOf(scene.area, cell_mm);
  const GroundSamples ground = sampleGround(*scene.terrain, grid);
  const double steepest = geometry::tangentOf(vehicle.max_slope_deg / 180 * geometry::kPi);
  const std::vector<float> climb_m =
      climbs(ground.base_m, grid, static_cast<float>(steepest * grid.sub_m()));
  const std::vector<uint8_t> reached =
      reachable(climb_m, grid, static_cast<float>(params.large_max_m), start);
  const Pieces pieces = piecesOf(scene, grid, at_s);
  CellJudge judge({scene, grid, ground, climb_m, reached, pieces}, vehicle, params);
  CellLayers layers(grid.extent);
  for (int32_t y = 0; y < grid.extent.height(); ++y)
  {
    for (int32_t x = 0; x < grid.extent.width(); ++x)
    {
      layers.put(x, y, judge.at(x, y));
    }
  }
  return layers.take(grid.lattice);
}
}  // namespace traverse::simulation
