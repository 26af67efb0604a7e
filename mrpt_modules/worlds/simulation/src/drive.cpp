// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "smooth_line.h"
#include "speed_profile.h"
#include "wheel_planes.h"

#include <traverse/simulation/drive.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
WheelPlane planeAt(const std::vector<WheelPlane>& planes, double index)
{
  const auto before = static_cast<size_t>(index);
  const WheelPlane& a = planes[before];
  const WheelPlane& b = planes[std::min(before + 1, planes.size() - 1)];
  const double f = index - static_cast<double>(before);
  const auto mixture = [f](double from, double to) { return (1 - f) * from + f * to; };
  return {mixture(a.z_m, b.z_m), mixture(a.forward, b.forward), mixture(a.left, b.left)};
}
}  // namespace

Motion driveOn(const Terrain& terrain, const DriveParams& params, const geometry::Vehicle& vehicle)
{
  options::check(params);
  const SmoothLine line(params.xs_m, params.ys_m);
  const SpeedProfile profile(params, line.lengthMetres());
  const double end_s = params.duration_s > 0 ? params.duration_s : profile.endSeconds();
  if (!(end_s > 0))
  {
    throw std::invalid_argument(
        "the drive takes no time: a line of one point needs [Drive] duration_s");
  }
  const std::vector<WheelPlane> planes = wheelPlanes(line, terrain, vehicle);
  const auto steps = static_cast<size_t>(std::ceil(end_s / kDriveStepSeconds - 1e-9));
  std::vector<TimedPose> poses;
  poses.reserve(steps + 1);
  for (size_t step = 0; step <= steps; ++step)
  {
    const double t_s = static_cast<double>(step) / 100;
    const double way_m = profile.wayAt(t_s);
    poses.push_back(
        {t_s,
         standing(line.at(way_m), planeAt(planes, line.indexAt(way_m)), vehicle.base_height_m)});
  }
  return Motion(std::move(poses));
}
}  // namespace traverse::simulation
