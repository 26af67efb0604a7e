// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

// A street without end over rolling ground, as an HDL-32E sees it, cheap enough for 100 km.
namespace traverse::testing
{
struct Box
{
  Eigen::Array3d min;
  Eigen::Array3d max;
};

/** How far along the ray the box is met; infinite where it is not. */
inline double distanceTo(const Box& box, const Eigen::Vector3d& from, const Eigen::Vector3d& along)
{
  const Eigen::Array3d a = (box.min - from.array()) / along.array();
  const Eigen::Array3d b = (box.max - from.array()) / along.array();
  const double enter = a.min(b).maxCoeff();
  const double leave = a.max(b).minCoeff();
  return enter >= 0 && enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/** The street is drawn once, straight and level, from as many places as it takes until it repeats
 * itself; each cloud bends it along the drive and lays it on the ground. On straight stretches all
 * clouds see one world. */
class EndlessStreet
{
 public:
  explicit EndlessStreet(double step_m) : step_m_(step_m)
  {
    for (int i = 0; i * step_m < kRepeat_m; ++i)
    {
      drawings_.push_back(draw(i * step_m));
    }
  }

  /** Hills of up to 8 %, on a plain that lies 90 m higher or lower some kilometres away. */
  static double ground_m(double x, double y)
  {
    return 2 * std::sin(x / 60) + 1.5 * std::sin(y / 45) + 90 * std::sin((x + y) / 8000);
  }

  /** Bends all along, and every 4 km a full circle 200 m wide, back to where the map was left. */
  static double heading_rad(double way_m)
  {
    const double in_circle_m = std::fmod(way_m, 4000) - 3300;
    const double turned = std::clamp(in_circle_m / 100, 0.0, 2 * std::numbers::pi);
    return 0.6 + 0.5 * std::sin(way_m / 700) + turned;
  }

  /** Where the vehicle is at each cloud of a drive. */
  std::vector<Eigen::Isometry3d> drive(double length_m) const
  {
    std::vector<Eigen::Isometry3d> poses;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (int i = 0; i * step_m_ < length_m; ++i)
    {
      p.z() = ground_m(p.x(), p.y());
      Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
      T.linear() =
          Eigen::AngleAxisd(heading_rad(i * step_m_), Eigen::Vector3d::UnitZ()).toRotationMatrix();
      T.translation() = p;
      poses.push_back(T);
      p += step_m_ * T.linear().col(0);
    }
    return poses;
  }

  /** The i-th cloud of a drive, taken at T. */
  const points::ScanBuffer& cloud(size_t i, const Eigen::Isometry3d& T)
  {
    const points::ScanBuffer& drawn = drawings_[i % drawings_.size()];
    cloud_ = drawn;
    cloud_.stamp = 1'600'000'000'000'000'000 + static_cast<int64_t>(i) * 500'000'000;
    for (size_t k = 0; k < drawn.size(); ++k)
    {
      const Eigen::Vector3d p = T * Eigen::Vector3d(drawn.x[k], drawn.y[k], 0);
      cloud_.z[k] += static_cast<float>(ground_m(p.x(), p.y()) - T.translation().z());
    }
    return cloud_;
  }

 private:
  static constexpr double kRepeat_m = 30;
  static constexpr double kMount_m = 1.84;
  static constexpr double kFarthest_m = 70;

  /** Road, kerbs 4 m to either side, walls 12 m to the right and 20 m to the left, parked cars. */
  static std::vector<Box> scene(double x_m)
  {
    std::vector<Box> boxes = {
        {{-500, -500, -1}, {500, 500, 0}},
        {{-500, 4, -1}, {500, 500, 0.12}},
        {{-500, -500, -1}, {500, -4, 0.12}},
        {{-500, -13, 0}, {500, -12, 3}},
        {{-500, 20, 0}, {500, 21, 2}}};
    for (int i = -5; i <= 5; ++i)
    {
      const double x = i * kRepeat_m - x_m;
      boxes.push_back({{x, 2.1, 0.25}, {x + 4.4, 3.8, 1.45}});
      boxes.push_back({{x + 11, -3.8, 0.3}, {x + 16, -2, 2.2}});
    }
    return boxes;
  }

  static points::ScanBuffer draw(double x_m)
  {
    constexpr int kBeams = 32;
    constexpr int kAzimuths = 180;
    constexpr double kRad = std::numbers::pi / 180;
    const std::vector<Box> boxes = scene(x_m);
    const Eigen::Vector3d from(0, 0, kMount_m);
    points::ScanBuffer scan;
    scan.sensor_label = "HDL-32E";
    scan.T_base_sensor.translation() = from;
    for (int i = 0; i < kBeams * kAzimuths; ++i)
    {
      const int beam = i % kBeams;
      const int azimuth = i / kBeams;
      const double up = (-30.67 + 41.34 / (kBeams - 1) * beam) * kRad;
      const double left = (360.0 / kAzimuths * azimuth + 0.5) * kRad;  // along no axis
      const Eigen::Vector3d along(
          std::cos(up) * std::cos(left), std::cos(up) * std::sin(left), std::sin(up));
      double range = std::numeric_limits<double>::infinity();
      for (const Box& box : boxes)
      {
        range = std::min(range, distanceTo(box, from, along));
      }
      if (range < kFarthest_m)
      {
        const Eigen::Vector3f p = (from + range * along).cast<float>();
        scan.x.push_back(p.x());
        scan.y.push_back(p.y());
        scan.z.push_back(p.z());
      }
    }
    return scan;
  }

  double step_m_;
  std::vector<points::ScanBuffer> drawings_;
  points::ScanBuffer cloud_;
};
}  // namespace traverse::testing
