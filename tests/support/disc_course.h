// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/reactive/reactive_driver.h>

#include <Eigen/Core>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace traverse::testing
{
/** A round thing to drive around. */
struct Disc
{
  Eigen::Vector2d centre;
  double radius_m = 0.3;
};

/** Discs anywhere in a box, none nearer than gap_m (between rims) to another, nor to the places. */
inline std::vector<Disc> randomDiscs(
    uint32_t seed, int most, double gap_m, const std::vector<Eigen::Vector2d>& places)
{
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  std::vector<Disc> discs;
  for (int n = 0; n < most; ++n)
  {
    const Disc disc{{uniform(0, 16), uniform(-6, 6)}, uniform(0.2, 0.6)};
    const auto is_near = [&](const Disc& other)
    { return (other.centre - disc.centre).norm() < other.radius_m + disc.radius_m + gap_m; };
    const auto is_on_way = [&](const Eigen::Vector2d& place)
    { return (place - disc.centre).norm() < disc.radius_m + gap_m / 2; };
    if (std::none_of(discs.begin(), discs.end(), is_near) &&
        std::none_of(places.begin(), places.end(), is_on_way))
    {
      discs.push_back(disc);
    }
  }
  return discs;
}

/** Of a map's point, in the vehicle's frame. */
inline Eigen::Vector2d seenFrom(const geometry::Pose2& pose, const Eigen::Vector2d& p)
{
  const Eigen::Vector2d d = p - Eigen::Vector2d(pose.x_m, pose.y_m);
  const double c = std::cos(pose.yaw_rad);
  const double s = std::sin(pose.yaw_rad);
  return {c * d.x() + s * d.y(), c * d.y() - s * d.x()};
}

/** Points on the discs' rims that lie within range, every 10 cm, 0.3 m high. */
inline std::vector<Eigen::Vector3f> rimsSeenFrom(
    const geometry::Pose2& pose, const std::vector<Disc>& discs, double range_m)
{
  std::vector<Eigen::Vector3f> points;
  for (const Disc& disc : discs)
  {
    const int n = static_cast<int>(std::ceil(2 * M_PI * disc.radius_m / 0.1));
    for (int k = 0; k < n; ++k)
    {
      const double a = 2 * M_PI * k / n;
      const Eigen::Vector2d p =
          seenFrom(pose, disc.centre + disc.radius_m * Eigen::Vector2d(std::cos(a), std::sin(a)));
      if (p.norm() < range_m)
      {
        points.emplace_back(p.x(), p.y(), 0.3);
      }
    }
  }
  return points;
}

/** From the box that the vehicle's corners span to the nearest disc, m; negative inside. */
inline double clearanceTo(
    const std::vector<Disc>& discs, const geometry::Pose2& pose, const geometry::Vehicle& vehicle)
{
  const auto [x0, x1] =
      std::minmax_element(vehicle.footprint_xs_m.begin(), vehicle.footprint_xs_m.end());
  const auto [y0, y1] =
      std::minmax_element(vehicle.footprint_ys_m.begin(), vehicle.footprint_ys_m.end());
  double least_m = std::numeric_limits<double>::infinity();
  for (const Disc& disc : discs)
  {
    const Eigen::Vector2d p = seenFrom(pose, disc.centre);
    const Eigen::Vector2d nearest(std::clamp(p.x(), *x0, *x1), std::clamp(p.y(), *y0, *y1));
    least_m = std::min(least_m, (p - nearest).norm() - disc.radius_m);
  }
  return least_m;
}

/** The pose after dt_s of an exact arc. */
inline geometry::Pose2 moved(
    const geometry::Pose2& from, const geometry::Twist2& twist, double dt_s)
{
  geometry::Pose2 to = from;
  to.yaw_rad += twist.yaw_rate_radps * dt_s;
  const double middle = from.yaw_rad + twist.yaw_rate_radps * dt_s / 2;
  to.x_m += twist.speed_mps * dt_s * std::cos(middle);
  to.y_m += twist.speed_mps * dt_s * std::sin(middle);
  return to;
}

/** How a drive went. */
struct Drive
{
  reactive::Outcome outcome = reactive::Outcome::idle;
  std::string text;
  geometry::Pose2 end;
  double seconds = 0;
  double least_clearance_m = std::numeric_limits<double>::infinity();
  double tightest_1pm = 0;  //!< largest curvature commanded
  int without_motion = 0;   //!< steps
  std::vector<double> step_ms;
};

/** Follows the places among the discs with a vehicle that does exactly what it is told, a command
 * every dt_s, until it arrives, has failed, stands for 3 s, or most_s are over. */
inline Drive driveAmong(
    const std::vector<Disc>& discs,
    const std::vector<Eigen::Vector2d>& places,
    reactive::ReactiveDriver& driver,
    const geometry::Vehicle& vehicle,
    double most_s,
    double dt_s = 0.05)
{
  Drive drive;
  reactive::Senses senses;
  senses.now = 1'700'000'000'000'000'000;
  senses.speed_limit_mps = 10;
  driver.follow(places);
  int standing = 0;
  for (; drive.seconds < most_s && standing * dt_s < 3; drive.seconds += dt_s)
  {
    senses.obstacles = rimsSeenFrom(senses.pose, discs, 8);
    const auto before = std::chrono::steady_clock::now();
    const reactive::Command command = driver.step(senses);
    drive.step_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before)
            .count());
    drive.outcome = command.outcome;
    drive.text = command.text;
    standing = command.outcome == reactive::Outcome::no_motion ? standing + 1 : 0;
    drive.without_motion += standing > 0 ? 1 : 0;
    if (command.outcome == reactive::Outcome::arrived ||
        command.outcome == reactive::Outcome::failed)
    {
      break;
    }
    if (std::abs(command.twist.speed_mps) > 1e-6)
    {
      drive.tightest_1pm = std::max(
          drive.tightest_1pm, std::abs(command.twist.yaw_rate_radps / command.twist.speed_mps));
    }
    senses.motion = command.twist;
    senses.pose = moved(senses.pose, command.twist, dt_s);
    senses.now = poses::later(senses.now, dt_s);
    drive.least_clearance_m =
        std::min(drive.least_clearance_m, clearanceTo(discs, senses.pose, vehicle));
  }
  drive.end = senses.pose;
  std::sort(drive.step_ms.begin(), drive.step_ms.end());
  return drive;
}
}  // namespace traverse::testing
