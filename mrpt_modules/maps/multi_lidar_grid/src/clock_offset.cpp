// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/clock_offset.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr double kBetweenKeys_s = 0.5;
constexpr size_t kMostKeys = 8;
constexpr size_t kMostPoints = 1500;
constexpr double kReach_m = 40;  // farther, a degree of attitude moves a point by more
constexpr double kVelocityChange_mps = 2;
constexpr int kEnoughPairs = 8;
constexpr double kClearPeak = 1.05;  // over the mean of all offsets
constexpr double kCell_m = 0.25;
constexpr int kSide = 2 * static_cast<int>(kReach_m / kCell_m);

/** The grid's index of a place in the vehicle frame of the grid's cloud; its rim has none. */
std::optional<int> cellOf(const Eigen::Vector3d& p)
{
  const double x = (p.x() + kReach_m) / kCell_m;
  const double y = (p.y() + kReach_m) / kCell_m;
  const bool is_inside = x >= 1 && y >= 1 && x < kSide - 1 && y < kSide - 1;
  return is_inside ? std::optional(static_cast<int>(y) * kSide + static_cast<int>(x))
                   : std::nullopt;
}

/** 4 in cells with a point, 2 beside and 1 across from them. */
std::vector<uint8_t> nearness(const std::vector<Eigen::Vector3d>& points)
{
  constexpr std::array<std::pair<int, uint8_t>, 9> kKernel = {
      {{-kSide - 1, 1},
       {-kSide, 2},
       {-kSide + 1, 1},
       {-1, 2},
       {0, 4},
       {1, 2},
       {kSide - 1, 1},
       {kSide, 2},
       {kSide + 1, 1}}};
  std::vector<uint8_t> grid(size_t{kSide} * kSide, 0);
  for (const Eigen::Vector3d& p : points)
  {
    const auto cell = cellOf(p);
    for (const auto& [step, near] : kKernel)
    {
      if (cell)
      {
        const int32_t at = *cell + step;
        uint8_t& value = grid[static_cast<size_t>(at)];
        value = std::max(value, near);
      }
    }
  }
  return grid;
}

std::vector<Eigen::Vector3d> upright(const points::Scan& scan, double low_m, double high_m)
{
  std::vector<Eigen::Vector3d> kept;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p(scan.x[i], scan.y[i], scan.z[i]);
    if (p.z() > low_m && p.z() < high_m && p.squaredNorm() < kReach_m * kReach_m)
    {
      kept.push_back(p);
    }
  }
  const size_t step = kept.size() / kMostPoints + 1;
  for (size_t i = 0; i * step < kept.size(); ++i)
  {
    kept[i] = kept[i * step];
  }
  kept.resize((kept.size() + step - 1) / step);
  return kept;
}

std::optional<Eigen::Vector3d> velocityAt(poses::TimeNs stamp, const poses::PoseTrack& track)
{
  constexpr poses::TimeNs kAround = 50'000'000;
  const auto before = track.at(stamp - kAround);
  const auto after = track.at(stamp + kAround);
  if (!before || !after || before->segment != after->segment)
  {
    return std::nullopt;
  }
  return Eigen::Vector3d(
      (after->T_map_base.translation() - before->T_map_base.translation()) / (2e-9 * kAround));
}

/** How near points fall to those of a grid, on the average. */
double agreement(
    const std::vector<uint8_t>& grid,
    const std::vector<Eigen::Vector3d>& points,
    const Eigen::Isometry3d& T_grid_points)
{
  uint64_t sum = 0;
  for (const Eigen::Vector3d& p : points)
  {
    const auto cell = cellOf(T_grid_points * p);
    sum += cell ? grid[static_cast<size_t>(*cell)] : 0;
  }
  return static_cast<double>(sum) / static_cast<double>(points.size());
}
}  // namespace

void ClockOffset::add(
    const points::Scan& scan, const poses::PoseTrack& track, double low_m, double high_m)
{
  const bool is_soon = !keys_.empty() && std::abs(poses::secondsBetween(
                                             keys_.back().stamp, scan.stamp)) < kBetweenKeys_s;
  if (is_soon || pairs_ >= kMostPairs)
  {
    return;
  }
  const auto velocity = velocityAt(scan.stamp, track);
  if (!track.moves() || !velocity)
  {
    return;
  }
  Key key{scan.stamp, *velocity, upright(scan, low_m, high_m), {}};
  if (key.p_base.empty())
  {
    return;
  }
  key.near = nearness(key.p_base);
  for (const Key& earlier : keys_)
  {
    if ((earlier.velocity - key.velocity).norm() > kVelocityChange_mps)
    {
      compare(earlier, key, track);
    }
  }
  keys_.push_back(std::move(key));
  if (keys_.size() > kMostKeys)
  {
    keys_.pop_front();
  }
}

void ClockOffset::compare(const Key& earlier, const Key& later_key, const poses::PoseTrack& track)
{
  std::array<double, kOffsets> found{};
  for (int i = 0; i < kOffsets; ++i)
  {
    const double offset_s = (i - kSteps) * kStep_s;
    const auto first = track.at(poses::later(earlier.stamp, offset_s));
    const auto second = track.at(poses::later(later_key.stamp, offset_s));
    if (!first || !second)
    {
      return;
    }
    found[static_cast<size_t>(i)] =
        agreement(earlier.near, later_key.p_base, first->T_map_base.inverse() * second->T_map_base);
  }
  std::transform(found.begin(), found.end(), score_.begin(), score_.begin(), std::plus<>());
  ++pairs_;
}

std::optional<double> ClockOffset::estimate_s() const
{
  const auto peak = std::max_element(score_.begin(), score_.end());
  double sum = 0;
  for (const double score : score_)
  {
    sum += score;
  }
  const bool at_edge = peak == score_.begin() || peak + 1 == score_.end();
  if (pairs_ < kEnoughPairs || at_edge || *peak * kOffsets < kClearPeak * sum)
  {
    return std::nullopt;
  }
  const double before = *(peak - 1);
  const double after = *(peak + 1);
  const double bend = before - 2 * *peak + after;
  const double part = bend < 0 ? 0.5 * (before - after) / bend : 0;
  return (static_cast<double>(peak - score_.begin()) - kSteps + part) * kStep_s;
}
}  // namespace traverse::multi_lidar_grid
