// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

// A world of ground, boxes and upright posts, and a spinning lidar that is driven through it: poses
// and points are known to the bit.
namespace traverse::testing
{
/** An upright cylinder from the ground to any height. */
struct Post
{
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius_m = 0.15;
};

/** What can be hit; z = 0 is ground where `has_ground`. */
struct AnalyticWorld
{
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<Post> posts;
  bool has_ground = true;

  /** Along a unit ray from outside of everything, or from within boxes (a room). */
  std::optional<double> range_m(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    const auto take = [&](double r)
    {
      if (r > 0.3 && r < nearest)
      {
        nearest = r;
      }
    };
    if (has_ground && along.z() < 0)
    {
      take(-from.z() / along.z());
    }
    for (const Eigen::AlignedBox3d& box : boxes)
    {
      const Eigen::Array3d a = (box.min() - from).array() / along.array();
      const Eigen::Array3d b = (box.max() - from).array() / along.array();
      const double in = a.min(b).maxCoeff();
      const double out = a.max(b).minCoeff();
      if (in <= out)
      {
        take(in > 0 ? in : out);
      }
    }
    for (const Post& post : posts)
    {
      const Eigen::Vector2d d = from.head<2>() - post.centre;
      const Eigen::Vector2d u = along.head<2>();
      const double half = d.dot(u);
      const double root =
          half * half - u.squaredNorm() * (d.squaredNorm() - post.radius_m * post.radius_m);
      if (root > 0)
      {
        take((-half - std::sqrt(root)) / u.squaredNorm());
      }
    }
    return std::isfinite(nearest) ? std::optional(nearest) : std::nullopt;
  }
};

/** House fronts with gaps and different depths on both sides of a road along x, cars, posts. */
inline AnalyticWorld street(double length_m = 200)
{
  AnalyticWorld world;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  for (const double side : {-1.0, 1.0})
  {
    for (double x = -60; x < length_m; x += 9 + 6 * any(random))
    {
      const double y = side * (9 + 3 * any(random));
      const double depth_m = side * 8;
      world.boxes.emplace_back(
          Eigen::Vector3d(x, std::min(y, y + depth_m), -1),
          Eigen::Vector3d(x + 5 + 4 * any(random), std::max(y, y + depth_m), 5 + 4 * any(random)));
      world.posts.push_back({{x + 3 * any(random), side * 6.5}, 0.12});
      if (any(random) < 0.6)
      {
        const double at = x + 4 * any(random);
        world.boxes.emplace_back(
            Eigen::Vector3d(at, side * 5 - 0.9, 0.3),
            Eigen::Vector3d(at + 4.2, side * 5 + 0.9, 1.5));
      }
    }
  }
  return world;
}

/** A room of 12 x 8 x 3 m with a wardrobe, a table top and a pillar; no edge lies on an axis. */
inline AnalyticWorld room()
{
  AnalyticWorld world;
  world.has_ground = false;
  world.boxes.emplace_back(Eigen::Vector3d(-5, -3.7, 0), Eigen::Vector3d(7, 4.3, 3));
  world.boxes.emplace_back(Eigen::Vector3d(4, 2, 0), Eigen::Vector3d(5.5, 3.5, 2));
  world.boxes.emplace_back(Eigen::Vector3d(-3, -3, 0.7), Eigen::Vector3d(-1.5, -1.5, 0.75));
  world.posts.push_back({{2.5, -2}, 0.3});
  return world;
}

/** Two endless walls and a floor: nothing tells how far along. */
inline AnalyticWorld corridor()
{
  AnalyticWorld world;
  world.boxes.emplace_back(Eigen::Vector3d(-1e4, 2, -1), Eigen::Vector3d(1e4, 3, 4));
  world.boxes.emplace_back(Eigen::Vector3d(-1e4, -3, -1), Eigen::Vector3d(1e4, -2, 4));
  return world;
}

/** Rings evenly between two elevations; turns once in `turn_s`, a column at a time. */
struct SpinningLidar
{
  int rings = 16;
  double lowest_deg = -15;
  double highest_deg = 15;
  int columns = 900;
  double turn_s = 0.1;
  double height_m = 1.8;  //!< over the vehicle's origin, which is on the ground
  double max_range_m = 100;
  double noise_m = 0;

  using Path = std::function<Eigen::Isometry3d(double t_s)>;

  /** The turn that ends at `stamp_s`; every point in the vehicle frame of its own time. */
  points::ScanBuffer scan(
      const AnalyticWorld& world, const Path& T_map_base, double stamp_s, poses::TimeNs start) const
  {
    std::mt19937_64 random(static_cast<uint64_t>(stamp_s * 1e3));
    std::normal_distribution<double> noise(0, noise_m);
    points::ScanBuffer scan;
    scan.stamp = start + std::llround(stamp_s * 1e9);
    scan.sensor_label = "LIDAR";
    scan.T_base_sensor.translation().z() = height_m;
    for (int column = 0; column < columns; ++column)
    {
      const double behind_s = turn_s * (column + 1 - columns) / columns;
      const Eigen::Isometry3d T = T_map_base(stamp_s + behind_s) * scan.T_base_sensor;
      const double a = -2 * std::numbers::pi * column / columns;
      for (int ring = 0; ring < rings; ++ring)
      {
        const double e =
            (lowest_deg + (highest_deg - lowest_deg) * ring / (rings - 1)) * std::numbers::pi / 180;
        const Eigen::Vector3d u(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
        const auto r = world.range_m(T.translation(), T.linear() * u);
        if (r && *r < max_range_m)
        {
          const double measured = *r + (noise_m > 0 ? noise(random) : 0);
          const Eigen::Vector3d p = scan.T_base_sensor * (measured * u);
          scan.x.push_back(static_cast<float>(p.x()));
          scan.y.push_back(static_cast<float>(p.y()));
          scan.z.push_back(static_cast<float>(p.z()));
          scan.time_s.push_back(static_cast<float>(behind_s));
          scan.ring.push_back(static_cast<uint16_t>(ring));
        }
      }
    }
    return scan;
  }
};
}  // namespace traverse::testing
