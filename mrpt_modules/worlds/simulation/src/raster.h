// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/scene_params.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::simulation
{
/** Heights at the nodes of a square grid, bilinear between them; beyond its border those of the
 * border. */
class Raster
{
 public:
  size_t columns = 0;
  size_t rows = 0;
  std::vector<float> heights_m;  //!< row by row; NaN: unknown
  double zero_m = 0;             //!< subtracted
  // node (column, row) of a place of the scene: to_node * place + shift
  Eigen::Matrix2d to_node = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  /** Above the height at the scene's zero. */
  double at(double x_m, double y_m) const;

  /** Gives unknown nodes the height of the nearest known one, counted in steps along rows and
   * columns (of several the one met first row by row). False where none is known. */
  bool fillUnknown();
};

/** Of params.file, its height at the scene's zero being 0. Throws std::runtime_error and
 * OptionError where a file is missing, damaged, knows nothing, or has heights beyond 10 km. */
std::shared_ptr<const Raster> loadRaster(const TerrainParams& params, const SceneParams& scene);

/** Argoverse 2's ground raster: NAME_ROWSxCOLS_float32.raw.gz and its transform. */
Raster heightRaster(const TerrainParams& params, const SceneParams& scene);

/** Bare-ground points as a grid over the scene's area: each node has the mean of its six nearest
 * points weighted by 1 / (squared distance + 1 cm2). */
Raster pointRaster(const TerrainParams& params, const SceneParams& scene);
}  // namespace traverse::simulation
