// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#include <traverse/multi_lidar_grid/clock_offset.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr double kBetweenKeys_s = 0.5;
constexpr size_t kMostKeys = 8;
constexpr size_t kMostPoints = 1500;
constexpr double kNearEnough_m = 40;  // farther, a degree of attitude moves a point by more
constexpr double kVelocityChange_mps = 2;
constexpr int kEnoughPairs = 8;
constexpr double kClearPeak = 1.05;  // over the mean of all offsets
constexpr int32_t kCell_mm = 300;

using Cells = std::unordered_set<uint64_t>;

std::optional<uint64_t> cellOf(const Eigen::Vector3d& p)
{
  if (!(p.array().abs() < geometry::kFarthest_m).all())
  {
    return std::nullopt;
  }
  const geometry::CellIndex cell = geometry::Lattice{kCell_mm}.cellOf(
      geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
  return uint64_t{static_cast<uint32_t>(cell.x)} << 32U | static_cast<uint32_t>(cell.y);
}

poses::TimeNs later(poses::TimeNs stamp, int step)
{
  return stamp + static_cast<poses::TimeNs>(std::llround(step * ClockOffset::kStep_s * 1e9));
}

std::vector<Eigen::Vector3d> upright(const points::Scan& scan, double low_m, double high_m)
{
  std::vector<Eigen::Vector3d> kept;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p(scan.x[i], scan.y[i], scan.z[i]);
    if (p.z() > low_m && p.z() < high_m && p.squaredNorm() < kNearEnough_m * kNearEnough_m)
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

/** Share of the later cloud's points in cells of the earlier one, both placed with an offset. */
std::optional<double> agreement(
    const std::vector<Eigen::Vector3d>& earlier,
    const Eigen::Isometry3d& T_map_earlier,
    const std::vector<Eigen::Vector3d>& later_points,
    const Eigen::Isometry3d& T_map_later)
{
  Cells cells;
  cells.reserve(earlier.size());
  for (const Eigen::Vector3d& p : earlier)
  {
    if (const auto cell = cellOf(T_map_earlier * p))
    {
      cells.insert(*cell);
    }
  }
  size_t met = 0;
  for (const Eigen::Vector3d& p : later_points)
  {
    const auto cell = cellOf(T_map_later * p);
    met += static_cast<size_t>(cell && cells.contains(*cell));
  }
  return later_points.empty() ? std::nullopt
                              : std::optional(static_cast<double>(met) / later_points.size());
}
}  // namespace

void ClockOffset::add(
    const points::Scan& scan, const poses::PoseTrack& track, double low_m, double high_m)
{
  if (!keys_.empty() &&
      std::abs(poses::secondsBetween(keys_.back().stamp, scan.stamp)) < kBetweenKeys_s)
  {
    return;
  }
  const auto velocity = velocityAt(scan.stamp, track);
  if (!track.moves() || !velocity)
  {
    return;
  }
  Key key{scan.stamp, *velocity, upright(scan, low_m, high_m)};
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
    const auto first = track.at(later(earlier.stamp, i - kSteps));
    const auto second = track.at(later(later_key.stamp, i - kSteps));
    if (!first || !second)
    {
      return;
    }
    const auto share =
        agreement(earlier.p_base, first->T_map_base, later_key.p_base, second->T_map_base);
    if (!share)
    {
      return;
    }
    found[static_cast<size_t>(i)] = *share;
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
