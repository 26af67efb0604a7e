// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_planes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
/** Front left, front right, rear left, rear right. */
using Heights = std::array<double, 4>;

/** The mean over the places up to kReach before and behind. */
std::vector<Heights> smoothed(const std::vector<Heights>& raw)
{
  constexpr size_t kReach = 6;
  std::vector<Heights> smooth(raw.size());
  for (size_t i = 0; i < raw.size(); ++i)
  {
    const size_t reach = std::min({kReach, i, raw.size() - 1 - i});
    for (size_t wheel = 0; wheel < smooth[i].size(); ++wheel)
    {
      double sum = 0;
      for (size_t j = i - reach; j <= i + reach; ++j)
      {
        sum += raw[j][wheel];
      }
      smooth[i][wheel] = sum / static_cast<double>(2 * reach + 1);
    }
  }
  return smooth;
}

Eigen::Vector3d unit(const Eigen::Vector3d& v)
{
  return v / std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
}
}  // namespace

Wheels::Wheels(const geometry::Vehicle& vehicle)
{
  if (vehicle.footprint_xs_m.empty() || vehicle.footprint_ys_m.empty())
  {
    throw std::invalid_argument("[Vehicle] footprint_xs_m and footprint_ys_m must hold numbers");
  }
  const auto xs = std::minmax_element(vehicle.footprint_xs_m.begin(), vehicle.footprint_xs_m.end());
  const auto ys = std::minmax_element(vehicle.footprint_ys_m.begin(), vehicle.footprint_ys_m.end());
  rear_m = *xs.first;
  front_m = *xs.second;
  right_m = *ys.first;
  left_m = *ys.second;
  if (!(front_m > rear_m) || !(left_m > right_m))
  {
    throw std::invalid_argument("[Vehicle]: the footprint must have a length and a width");
  }
}

Eigen::Vector2d Wheels::onMap(const SmoothLine::Place& place, const Eigen::Vector2d& p_vehicle)
{
  const Eigen::Vector2d& h = place.heading;
  return {
      place.p.x() + h.x() * p_vehicle.x() - h.y() * p_vehicle.y(),
      place.p.y() + h.y() * p_vehicle.x() + h.x() * p_vehicle.y()};
}

std::array<double, 4> Wheels::heights(const Terrain& terrain, const SmoothLine::Place& place) const
{
  Heights z{};
  const std::array<Eigen::Vector2d, 4> wheels = corners();
  for (size_t i = 0; i < z.size(); ++i)
  {
    const Eigen::Vector2d at = onMap(place, wheels[i]);
    z[i] = terrain.at(at.x(), at.y()).height_m;
  }
  return z;
}

WheelPlane Wheels::planeOf(const std::array<double, 4>& z) const
{
  WheelPlane plane;
  plane.forward = ((z[0] + z[1]) - (z[2] + z[3])) / 2 / (front_m - rear_m);
  plane.left = ((z[0] + z[2]) - (z[1] + z[3])) / 2 / (left_m - right_m);
  plane.z_m = (z[0] + z[1] + z[2] + z[3]) / 4 - plane.forward * (front_m + rear_m) / 2 -
              plane.left * (left_m + right_m) / 2;
  return plane;
}

std::vector<WheelPlane> wheelPlanes(
    const SmoothLine& line, const Terrain& terrain, const geometry::Vehicle& vehicle)
{
  const Wheels wheels(vehicle);
  std::vector<Heights> heights;
  heights.reserve(line.places().size());
  for (const SmoothLine::Place& place : line.places())
  {
    heights.push_back(wheels.heights(terrain, place));
  }
  heights = smoothed(smoothed(heights));
  std::vector<WheelPlane> planes;
  planes.reserve(heights.size());
  for (const Heights& z : heights)
  {
    planes.push_back(wheels.planeOf(z));
  }
  return planes;
}

Eigen::Isometry3d standing(
    const SmoothLine::Place& place, const WheelPlane& plane, double base_height_m)
{
  const Eigen::Vector2d& h = place.heading;
  const Eigen::Vector3d x = unit({h.x(), h.y(), plane.forward});
  const Eigen::Vector3d z = unit(x.cross(Eigen::Vector3d(-h.y(), h.x(), plane.left)));
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.linear().col(0) = x;
  T_map_base.linear().col(1) = z.cross(x);
  T_map_base.linear().col(2) = z;
  T_map_base.translation() =
      Eigen::Vector3d(place.p.x(), place.p.y(), plane.z_m) + base_height_m * z;
  return T_map_base;
}
}  // namespace traverse::simulation
