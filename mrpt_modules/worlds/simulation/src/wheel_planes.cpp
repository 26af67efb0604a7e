// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_planes.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace traverse::simulation
{
namespace
{
/** Front left, front right, rear left, rear right. */
using Heights = std::array<double, 4>;

/** The box round the footprint, in the vehicle frame. */
struct Wheels
{
  double front_m, rear_m, left_m, right_m;

  explicit Wheels(const geometry::Vehicle& vehicle)
  {
    if (vehicle.footprint_xs_m.empty() || vehicle.footprint_ys_m.empty())
    {
      throw std::invalid_argument("[Vehicle] footprint_xs_m and footprint_ys_m must hold numbers");
    }
    const auto xs =
        std::minmax_element(vehicle.footprint_xs_m.begin(), vehicle.footprint_xs_m.end());
    const auto ys =
        std::minmax_element(vehicle.footprint_ys_m.begin(), vehicle.footprint_ys_m.end());
    rear_m = *xs.first;
    front_m = *xs.second;
    right_m = *ys.first;
    left_m = *ys.second;
    if (!(front_m > rear_m) || !(left_m > right_m))
    {
      throw std::invalid_argument("[Vehicle]: the footprint must have a length and a width");
    }
  }
};

double heightAt(const Terrain& terrain, const SmoothLine::Place& place, double x_m, double y_m)
{
  const Eigen::Vector2d& h = place.heading;
  return terrain
      .at(place.p.x() + h.x() * x_m - h.y() * y_m, place.p.y() + h.y() * x_m + h.x() * y_m)
      .height_m;
}

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

WheelPlane planeOf(const Heights& z, const Wheels& wheels)
{
  WheelPlane plane;
  plane.forward = ((z[0] + z[1]) - (z[2] + z[3])) / 2 / (wheels.front_m - wheels.rear_m);
  plane.left = ((z[0] + z[2]) - (z[1] + z[3])) / 2 / (wheels.left_m - wheels.right_m);
  plane.z_m = (z[0] + z[1] + z[2] + z[3]) / 4 -
              plane.forward * (wheels.front_m + wheels.rear_m) / 2 -
              plane.left * (wheels.left_m + wheels.right_m) / 2;
  return plane;
}
}  // namespace

std::vector<WheelPlane> wheelPlanes(
    const SmoothLine& line, const Terrain& terrain, const geometry::Vehicle& vehicle)
{
  const Wheels wheels(vehicle);
  std::vector<Heights> heights;
  heights.reserve(line.places().size());
  for (const SmoothLine::Place& place : line.places())
  {
    heights.push_back(
        {heightAt(terrain, place, wheels.front_m, wheels.left_m),
         heightAt(terrain, place, wheels.front_m, wheels.right_m),
         heightAt(terrain, place, wheels.rear_m, wheels.left_m),
         heightAt(terrain, place, wheels.rear_m, wheels.right_m)});
  }
  heights = smoothed(smoothed(heights));
  std::vector<WheelPlane> planes;
  planes.reserve(heights.size());
  for (const Heights& z : heights)
  {
    planes.push_back(planeOf(z, wheels));
  }
  return planes;
}
}  // namespace traverse::simulation
