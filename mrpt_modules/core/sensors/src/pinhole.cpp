// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sensors/pinhole.h>

#include <algorithm>
#include <cmath>

namespace traverse::sensors
{
namespace
{
constexpr int kMaxIterations = 50;
constexpr double kConverged = 1e-9;

/** The radial factor and the tangential shift at an undistorted, normalised place. */
struct Distortion
{
  double factor, shift_x, shift_y;
};

Distortion distortionAt(const std::array<double, 8>& d, double x, double y)
{
  const double r2 = x * x + y * y;
  const double numerator = 1 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
  const double denominator = 1 + r2 * (d[5] + r2 * (d[6] + r2 * d[7]));
  return {
      numerator / denominator, 2 * d[2] * x * y + d[3] * (r2 + 2 * x * x),
      d[2] * (r2 + 2 * y * y) + 2 * d[3] * x * y};
}
}  // namespace

bool Pinhole::valid() const
{
  const auto finite = [](double v) { return std::isfinite(v); };
  return columns > 0 && rows > 0 && fx_px > 0 && fy_px > 0 && finite(fx_px) && finite(fy_px) &&
         finite(cx_px) && finite(cy_px) &&
         std::all_of(distortion.begin(), distortion.end(), finite);
}

bool Pinhole::distorts() const
{
  return std::any_of(distortion.begin(), distortion.end(), [](double v) { return v != 0; });
}

std::optional<Eigen::Vector2d> project(const Pinhole& camera, const Eigen::Vector3d& p_optical)
{
  if (!(p_optical.z() > 0))
  {
    return std::nullopt;
  }
  double x = p_optical.x() / p_optical.z();
  double y = p_optical.y() / p_optical.z();
  if (camera.distorts())
  {
    const Distortion at = distortionAt(camera.distortion, x, y);
    x = x * at.factor + at.shift_x;
    y = y * at.factor + at.shift_y;
  }
  return Eigen::Vector2d(camera.fx_px * x + camera.cx_px, camera.fy_px * y + camera.cy_px);
}

std::optional<Eigen::Vector3d> ray(const Pinhole& camera, double u_px, double v_px)
{
  const double seen_x = (u_px - camera.cx_px) / camera.fx_px;
  const double seen_y = (v_px - camera.cy_px) / camera.fy_px;
  if (!camera.distorts())
  {
    return Eigen::Vector3d(seen_x, seen_y, 1);
  }
  double x = seen_x;
  double y = seen_y;
  for (int i = 0; i < kMaxIterations; ++i)
  {
    const Distortion at = distortionAt(camera.distortion, x, y);
    const double next_x = (seen_x - at.shift_x) / at.factor;
    const double next_y = (seen_y - at.shift_y) / at.factor;
    const double moved = std::hypot(next_x - x, next_y - y);
    x = next_x;
    y = next_y;
    if (moved < kConverged)
    {
      return Eigen::Vector3d(x, y, 1);
    }
  }
  return std::nullopt;
}
}  // namespace traverse::sensors
