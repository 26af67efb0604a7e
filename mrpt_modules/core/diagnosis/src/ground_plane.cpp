// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/diagnosis/ground_plane.h>
#include <traverse/points/sensor_origin.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace traverse::diagnosis
{
namespace
{
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kNear_m = 0.1;             // a point so near to a plane lies on it
constexpr double kBelow_m = 0.4;            // and so far below it speaks against it
constexpr double kMostBelow = 0.03;         // share of points that may
constexpr double kLeastShare = 0.1;         // of the points that a ground must have,
constexpr double kLeastShareAround = 0.03;  // or where it is seen all around
constexpr size_t kMostOfThem = 5;           // sectors; a wall along the road has 4 at most
constexpr size_t kMostPoints = 3000;        // looked at
constexpr int kTries = 400;
constexpr size_t kSectors = 8;

/** Points around the sensor, relative to it, thinned evenly. */
std::vector<Eigen::Vector3d> pointsAround(const points::Scan& scan, const Eigen::Vector3d& sensor)
{
  constexpr double kNearest_m = 1;
  constexpr double kFarthest_m = 30;
  std::vector<Eigen::Vector3d> all;
  all.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]) - sensor;
    const double range_m = p.norm();
    if (range_m >= kNearest_m && range_m <= kFarthest_m)
    {
      all.push_back(p);
    }
  }
  const size_t step = all.size() / kMostPoints + 1;
  std::vector<Eigen::Vector3d> some;
  some.reserve(all.size() / step + 1);
  for (size_t i = 0; i < all.size(); i += step)
  {
    some.push_back(all[i]);
  }
  return some;
}

/** A plane below the sensor at the origin: up . p = -height. */
struct Candidate
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double height_m = 0;
  size_t on = 0;

  double above(const Eigen::Vector3d& p) const { return up.dot(p) + height_m; }
};

Candidate towardsSensor(const Eigen::Vector3d& normal, const Eigen::Vector3d& point)
{
  const double height_m = -normal.dot(point);
  return height_m >= 0 ? Candidate{normal, height_m} : Candidate{-normal, -height_m};
}

/** Sectors around the sensor's foot on the plane, seen along `up`, in which the plane has points
 * further out than walls are high. */
size_t sectorsSeen(const Candidate& plane, const std::vector<Eigen::Vector3d>& points)
{
  constexpr double kFarOut_m = 6;
  const Eigen::Vector3d ahead = plane.up.unitOrthogonal();
  const Eigen::Vector3d left = plane.up.cross(ahead);
  std::array<size_t, kSectors> count{};
  for (const Eigen::Vector3d& p : points)
  {
    const double x_m = ahead.dot(p);
    const double y_m = left.dot(p);
    if (std::abs(plane.above(p)) <= kNear_m && std::hypot(x_m, y_m) >= kFarOut_m)
    {
      const double turn = std::atan2(y_m, x_m) / (2 * std::numbers::pi) + 0.5;
      ++count[std::min(kSectors - 1, static_cast<size_t>(turn * kSectors))];
    }
  }
  constexpr size_t kFew = 5;
  return static_cast<size_t>(
      std::count_if(count.begin(), count.end(), [](size_t n) { return n >= kFew; }));
}

bool allowed(
    const Candidate& plane, GroundSearch search, const std::vector<Eigen::Vector3d>& points)
{
  if (search == GroundSearch::level)
  {
    return plane.up.z() >= std::cos(GroundPlane::kMostTilt_deg * kDegree);
  }
  return sectorsSeen(plane, points) >= kMostOfThem;
}

size_t countOn(const Candidate& plane, const std::vector<Eigen::Vector3d>& points)
{
  size_t on = 0;
  size_t below = 0;
  for (const Eigen::Vector3d& p : points)
  {
    const double above_m = plane.above(p);
    on += std::abs(above_m) <= kNear_m ? 1 : 0;
    below += above_m < -kBelow_m ? 1 : 0;
  }
  const auto most_below = static_cast<size_t>(kMostBelow * static_cast<double>(points.size()));
  return below > most_below ? 0 : on;
}

Candidate bestPlane(const std::vector<Eigen::Vector3d>& points, GroundSearch search)
{
  std::mt19937 random(1);
  const auto any = [&]() -> const Eigen::Vector3d& { return points[random() % points.size()]; };
  Candidate best;
  for (int i = 0; i < kTries; ++i)
  {
    const Eigen::Vector3d& a = any();
    const Eigen::Vector3d normal = (any() - a).cross(any() - a);
    if (!(normal.norm() > 1e-3))
    {
      continue;
    }
    Candidate plane = towardsSensor(normal.normalized(), a);
    plane.on = countOn(plane, points);
    if (plane.on > best.on && allowed(plane, search, points))
    {
      best = plane;
    }
  }
  return best;
}

/** The least-squares plane through the points on `plane`. */
GroundPlane fitted(const Candidate& plane, const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double n = 0;
  for (const Eigen::Vector3d& p : points)
  {
    if (std::abs(plane.above(p)) <= kNear_m)
    {
      mean += p;
      squares += p * p.transpose();
      n += 1;
    }
  }
  mean /= n;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      squares / n - mean * mean.transpose());
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const Eigen::Vector3d up = normal.dot(plane.up) < 0 ? Eigen::Vector3d(-normal) : normal;
  const Candidate better{up, -up.dot(mean)};
  GroundPlane ground;
  ground.up = better.up;
  ground.sensor_m = better.height_m;
  ground.rms_m = std::sqrt(std::max(0.0, solver.eigenvalues()(0)));
  ground.share = n / static_cast<double>(points.size());
  return ground;
}

double medianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Median, and median distance from it. */
std::pair<double, double> medianAndSpread(std::vector<double> values)
{
  const double median = medianOf(values);
  for (double& v : values)
  {
    v = std::abs(v - median);
  }
  return {median, medianOf(std::move(values))};
}

template <class Get>
std::vector<double> each(std::span<const GroundPlane> planes, const Get& get)
{
  std::vector<double> values(planes.size());
  std::transform(planes.begin(), planes.end(), values.begin(), get);
  return values;
}
}  // namespace

double GroundPlane::pitch_deg() const
{
  return std::atan2(up.x(), up.z()) / kDegree;
}

double GroundPlane::roll_deg() const
{
  return std::atan2(up.y(), up.z()) / kDegree;
}

std::optional<GroundPlane> findGround(const points::Scan& scan, GroundSearch search)
{
  constexpr size_t kFewest = 100;
  const Eigen::Vector3d sensor = points::sensorOrigin(scan.T_base_sensor);
  const std::vector<Eigen::Vector3d> points = pointsAround(scan, sensor);
  if (points.size() < kFewest)
  {
    return std::nullopt;
  }
  const Candidate plane = bestPlane(points, search);
  const bool around = sectorsSeen(plane, points) >= kMostOfThem;
  const double least =
      (around ? kLeastShareAround : kLeastShare) * static_cast<double>(points.size());
  if (static_cast<double>(plane.on) < least)
  {
    return std::nullopt;
  }
  GroundPlane ground = fitted(plane, points);
  if (!allowed({ground.up, ground.sensor_m}, search, points))
  {
    return std::nullopt;
  }
  ground.offset_m = ground.up.dot(sensor) - ground.sensor_m;
  return ground;
}

std::optional<GroundSeen> agree(std::span<const GroundPlane> planes)
{
  if (planes.empty())
  {
    return std::nullopt;
  }
  GroundSeen seen;
  seen.scans = planes.size();
  std::tie(seen.offset_m, seen.offset_spread_m) =
      medianAndSpread(each(planes, [](const GroundPlane& p) { return p.offset_m; }));
  std::tie(seen.pitch_deg, seen.pitch_spread_deg) =
      medianAndSpread(each(planes, [](const GroundPlane& p) { return p.pitch_deg(); }));
  std::tie(seen.roll_deg, seen.roll_spread_deg) =
      medianAndSpread(each(planes, [](const GroundPlane& p) { return p.roll_deg(); }));
  seen.sensor_m = medianOf(each(planes, [](const GroundPlane& p) { return p.sensor_m; }));
  seen.up = Eigen::Vector3d(
                medianOf(each(planes, [](const GroundPlane& p) { return p.up.x(); })),
                medianOf(each(planes, [](const GroundPlane& p) { return p.up.y(); })),
                medianOf(each(planes, [](const GroundPlane& p) { return p.up.z(); })))
                .normalized();
  return seen;
}
}  // namespace traverse::diagnosis
