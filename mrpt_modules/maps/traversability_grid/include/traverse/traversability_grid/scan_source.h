// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/traversability_grid/params.h>
#include <traverse/traversability_grid/scan_cells.h>

#include <Eigen/Geometry>

#include <cstdint>

namespace traverse::traversability_grid
{
/** Where the last scan's points come from: when, from which sensor, and how exact its heights are.
 *
 * A range r with standard deviation s_r and a direction with s_a, at elevation e, give a height the
 * variance (s_r sin e)^2 + (s_a r cos e)^2: small for steep beams nearby, growing with the range.
 */
class ScanSource
{
 public:
  ScanSource(
      const points::Scan& scan,
      const Eigen::Isometry3d& T_map_base,
      uint32_t sensor_bit,
      const Params& params);

  poses::TimeNs stamp() const { return stamp_; }

  /** The sums of a slab with their stamp, sensor and noise. */
  layers::HeightSlab sumsOf(const ScanSlab& slab, int32_t cell_mm, int32_t slab_mm) const;

 private:
  poses::TimeNs stamp_;
  uint32_t sensor_bit_;
  bool has_place_ = true;      // false: points that no sensor saw from one place
  double x_mm_, y_mm_, z_mm_;  // of the sensor, map frame
  double range_variance_;      // in (0.1 mm)^2
  double angle_variance_;      // in (0.1 mm)^2 per mm^2
};
}  // namespace traverse::traversability_grid
