// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/traversability_grid/point_labels.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <cmath>
#include <support/labelled_clouds.h>
#include <vector>

namespace traverse::testing
{
/** Ground found, missed, and wrongly called, over points at 3 to 60 m that have a truth. */
struct GroundScore
{
  double found = 0;   // ground, called ground
  double missed = 0;  // ground, called something else
  double wrong = 0;   // called ground, and is none

  void add(bool is_ground, bool called_ground)
  {
    found += is_ground && called_ground ? 1 : 0;
    missed += is_ground && !called_ground ? 1 : 0;
    wrong += !is_ground && called_ground ? 1 : 0;
  }

  void add(
      const LabelledCloud& cloud,
      Layout layout,
      const std::vector<traversability_grid::PointLabel>& labels)
  {
    constexpr double kNearest_m = 3;
    constexpr double kFarthest_m = 60;
    for (size_t i = 0; i < labels.size(); ++i)
    {
      const float x = cloud.scan.x[i];
      const float y = cloud.scan.y[i];
      const float z = cloud.scan.z[i];
      const double range = std::sqrt(x * x + y * y + z * z);
      const std::optional<bool> truth = isGround(layout, cloud.labels[i]);
      if (truth && range >= kNearest_m && range <= kFarthest_m)
      {
        add(*truth, labels[i] == traversability_grid::PointLabel::ground);
      }
    }
  }

  double f1() const { return 2 * found / (2 * found + missed + wrong); }

  double precision() const { return found / (found + wrong); }

  double recall() const { return found / (found + missed); }
};

/** The labels of one cloud by itself, from a map with default options but these. */
inline std::vector<traversability_grid::PointLabel> labelsOf(
    const LabelledCloud& cloud, traversability_grid::ClassifierKind classifier, double mount_m)
{
  traversability_grid::Params params;
  params.classifier = classifier;
  params.mode = traversability_grid::Mode::single_cloud;
  geometry::Vehicle vehicle;
  vehicle.base_height_m = mount_m;
  traversability_grid::State state = traversability_grid::makeState(params, vehicle);
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  traversability_grid::update(state, cloud.scan.view(), here, params, vehicle);
  return traversability_grid::labelsOfLastScan(state, cloud.scan.view(), here, params);
}
}  // namespace traverse::testing
