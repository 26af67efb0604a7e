// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

namespace traverse::points
{
/** Where a scan's sensor is in the vehicle frame, m; the vehicle's origin for scans that are from
 * no one place (Scan::T_base_sensor is NaN). */
inline Eigen::Vector3d sensorOrigin(const Eigen::Isometry3d& T_base_sensor)
{
  return T_base_sensor.matrix().allFinite() ? Eigen::Vector3d(T_base_sensor.translation())
                                            : Eigen::Vector3d::Zero();
}
}  // namespace traverse::points
