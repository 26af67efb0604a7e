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
  double factor;
  Eigen::Vector2d shift;
};

Distortion distortionAt(const std::array<double, 8>& d, const Eigen::Vector2d& p)
{
  const double r2 = p.squaredNorm();
  const double numerator = 1 + r2 * (d[0] + r2 * (d[1] + r2 * d[4]));
  const double denominator = 1 + r2 * (d[5] + r2 * (d[6] + r2 * d[7]));
  const double xy = p.x() * p.y();
  return {
      numerator / denominator,
      {2 * d[2] * xy + d[3] * (r2 + 2 * p.x() * p.x()),
       d[2] * (r2 + 2 * p.y() * p.y()) + 2 * d[3] * xy}};
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
  Eigen::Vector2d p = p_optical.head<2>() / p_optical.z();
  if (camera.distorts())
  {
    const Distortion at = distortionAt(camera.distortion, p);
    p = p * at.factor + at.shift;
  }
  return Eigen::Vector2d(camera.fx_px * p.x() + camera.cx_px, camera.fy_px * p.y() + camera.cy_px);
}

std::optional<Eigen::Vector3d> ray(const Pinhole& camera, double u_px, double v_px)
{
  const Eigen::Vector2d seen(
      (u_px - camera.cx_px) / camera.fx_px, (v_px - camera.cy_px) / camera.fy_px);
  if (!camera.distorts())
  {
    return Eigen::Vector3d(seen.x(), seen.y(), 1);
  }
  Eigen::Vector2d p = seen;
  for (int i = 0; i < kMaxIterations; ++i)
  {
    const Distortion at = distortionAt(camera.distortion, p);
    const Eigen::Vector2d next = (seen - at.shift) / at.factor;
    const double moved = (next - p).norm();
    p = next;
    if (moved < kConverged)
    {
      return Eigen::Vector3d(p.x(), p.y(), 1);
    }
  }
  return std::nullopt;
}
}  // namespace traverse::sensors
