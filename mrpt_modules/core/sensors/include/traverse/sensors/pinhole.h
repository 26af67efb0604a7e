// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>

namespace traverse::sensors
{
/** A camera with radial and tangential distortion (the "plumb bob" model). Optical frame: x right,
 * y down, z forward; pixel (0, 0) is the centre of the upper left one. */
struct Pinhole
{
  int columns = 0;
  int rows = 0;
  double fx_px = 0;  //!< focal lengths
  double fy_px = 0;
  double cx_px = 0;  //!< principal point
  double cy_px = 0;
  /** k1 k2 p1 p2 k3 k4 k5 k6, as OpenCV orders them; all zero: none. */
  std::array<double, 8> distortion{};

  /** True where size and focal lengths are those of a camera, and every number is finite. */
  bool valid() const;

  bool distorts() const;
};

/** Where a point of the optical frame (m) is seen, px; nothing behind the camera. May lie outside
 * the picture. */
std::optional<Eigen::Vector2d> project(const Pinhole& camera, const Eigen::Vector3d& p_optical);

/** The ray through a pixel, scaled to z = 1 in the optical frame. The distortion is undone by fixed
 * point iteration to 1e-9; nothing where it does not converge, which means the lens model does not
 * hold there. */
std::optional<Eigen::Vector3d> ray(const Pinhole& camera, double u_px, double v_px);
}  // namespace traverse::sensors
