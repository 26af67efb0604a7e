// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/diagnosis/crispness.h>
#include <traverse/points/sensor_origin.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace traverse::diagnosis
{
namespace
{
constexpr double kCell_m = 0.25;
constexpr double kStretch_s = 4;
constexpr size_t kMostStretches = 4;
constexpr size_t kFewestScans = 10;
constexpr size_t kMostPoints = 600;  // of a scan
constexpr double kSlice_s = 0.005;   // points so near in time share a pose
constexpr double kDegree = std::numbers::pi / 180;

/** Of a grid that is turned by 3:4 against the map: a wall along an axis, as towns have many, would
 * fill one row of cells or two, by chance. */
uint64_t cellKey(const Eigen::Vector3d& p)
{
  const auto cell = [](double v)
  { return static_cast<uint32_t>(static_cast<int32_t>(std::floor(v / kCell_m))); };
  return uint64_t{cell(0.8 * p.x() - 0.6 * p.y())} << 32U | cell(0.6 * p.x() + 0.8 * p.y());
}

double headingChange(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to)
{
  const Eigen::Matrix3d turn = from.linear().transpose() * to.linear();
  return std::abs(std::atan2(turn(1, 0), turn(0, 0)));
}

/** Cells that a scan's points fall in, with poses of `shift` later; those without a pose are left
 * out, and counted out of `points`. */
class Painter
{
 public:
  Painter(const poses::PoseTrack& track, double time_s, double heading_rad) :
      track_(track),
      time_s_(time_s),
      turn_(Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()))
  {
  }

  void paint(const Sighted& scan, std::vector<uint64_t>& cells) const
  {
    std::optional<poses::TrackedPose> pose;
    double slice = std::nan("");
    for (size_t i = 0; i < scan.p_base.size(); ++i)
    {
      const double time_s = scan.time_s.empty() ? 0.0 : scan.time_s[i];
      const double this_slice = std::floor(time_s / kSlice_s);
      if (this_slice != slice)
      {
        slice = this_slice;
        pose = track_.at(poses::later(scan.stamp, (slice + 0.5) * kSlice_s + time_s_));
      }
      if (pose)
      {
        cells.push_back(cellKey(pose->T_map_base * (turn_ * scan.p_base[i].cast<double>())));
      }
    }
  }

 private:
  const poses::PoseTrack& track_;
  double time_s_;
  Eigen::Matrix3d turn_;
};

/** The value of least cost among those from -most to most: coarse first, then ten times finer. */
BestFit leastOf(const std::function<double(double)>& cost, double most, double coarse)
{
  const double at_zero = cost(0);
  double best = 0;
  double best_cost = at_zero;
  double worst_cost = at_zero;
  const auto try_around = [&](double middle, double step, int steps)
  {
    for (int i = -steps; i <= steps; ++i)
    {
      const double value = middle + i * step;
      const double c = std::abs(value) > most ? at_zero : cost(value);
      worst_cost = std::max(worst_cost, c);
      if (c < best_cost)
      {
        best = value;
        best_cost = c;
      }
    }
  };
  try_around(0, coarse, static_cast<int>(std::lround(most / coarse)));
  try_around(best, coarse / 10, 9);
  return {best, at_zero / best_cost - 1, worst_cost / best_cost - 1};
}
}  // namespace

Sighted sightedBy(
    const points::Scan& scan, const Eigen::Vector3d& up, double offset_m, double above_m)
{
  constexpr double kNearest_m = 2;
  constexpr double kFarthest_m = 40;
  const Eigen::Vector3d sensor = points::sensorOrigin(scan.T_base_sensor);
  std::vector<size_t> upright;
  upright.reserve(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p(scan.x[i], scan.y[i], scan.z[i]);
    const double range_m = (p - sensor).norm();
    if (range_m >= kNearest_m && range_m <= kFarthest_m && up.dot(p) - offset_m >= above_m)
    {
      upright.push_back(i);
    }
  }
  Sighted sighted;
  sighted.stamp = scan.stamp;
  const size_t step = upright.size() / kMostPoints + 1;
  for (size_t k = 0; k < upright.size(); k += step)
  {
    const size_t i = upright[k];
    sighted.p_base.emplace_back(scan.x[i], scan.y[i], scan.z[i]);
    if (!scan.time_s.empty())
    {
      sighted.time_s.push_back(scan.time_s[i]);
    }
  }
  return sighted;
}

Crispness::Crispness(std::vector<Sighted> scans, const poses::PoseTrack& track) : track_(track)
{
  scans_.reserve(scans.size());
  for (Sighted& scan : scans)
  {
    if (!scan.p_base.empty() && track.at(scan.stamp))
    {
      scans_.push_back(std::move(scan));
    }
  }
  std::sort(
      scans_.begin(), scans_.end(),
      [](const Sighted& a, const Sighted& b) { return a.stamp < b.stamp; });
}

std::vector<Crispness::Stretch> Crispness::stretches() const
{
  std::vector<Stretch> all;
  for (size_t i = 0; i < scans_.size(); ++i)
  {
    if (all.empty() ||
        poses::secondsBetween(scans_[all.back().front()].stamp, scans_[i].stamp) > kStretch_s)
    {
      all.emplace_back();
    }
    all.back().push_back(i);
  }
  return all;
}

std::vector<Crispness::Stretch> Crispness::mostOf(bool turning) const
{
  const auto amount = [&](const Stretch& stretch)
  {
    double sum = 0;
    for (size_t k = 1; k < stretch.size(); ++k)
    {
      const auto a = track_.at(scans_[stretch[k - 1]].stamp)->T_map_base;
      const auto b = track_.at(scans_[stretch[k]].stamp)->T_map_base;
      sum += turning ? headingChange(a, b) : (b.translation() - a.translation()).norm();
    }
    return sum;
  };
  std::vector<Stretch> all = stretches();
  std::stable_sort(
      all.begin(), all.end(),
      [&](const Stretch& a, const Stretch& b) { return amount(a) > amount(b); });
  all.resize(std::min(all.size(), kMostStretches));
  return all;
}

double Crispness::filled(const std::vector<Stretch>& stretches, const Shift& shift) const
{
  const Painter painter(track_, shift.time_s, shift.heading_rad);
  double filled = 0;
  double painted = 0;
  std::vector<uint64_t> cells;
  for (const Stretch& stretch : stretches)
  {
    cells.clear();
    for (const size_t i : stretch)
    {
      painter.paint(scans_[i], cells);
    }
    painted += static_cast<double>(cells.size());
    std::sort(cells.begin(), cells.end());
    filled += static_cast<double>(std::unique(cells.begin(), cells.end()) - cells.begin());
  }
  return painted > 0 ? filled / painted : 1.0;
}

std::optional<BestFit> Crispness::timeOffset(double most_s) const
{
  if (scans_.size() < kFewestScans)
  {
    return std::nullopt;
  }
  const std::vector<Stretch> turns = mostOf(true);
  return leastOf([&](double time_s) { return filled(turns, {time_s, 0}); }, most_s, most_s / 10);
}

std::optional<BestFit> Crispness::heading() const
{
  if (scans_.size() < kFewestScans)
  {
    return std::nullopt;
  }
  constexpr double kHalfTurn_deg = 180;
  const std::vector<Stretch> ways = mostOf(false);
  return leastOf([&](double deg) { return filled(ways, {0, deg * kDegree}); }, kHalfTurn_deg, 2);
}
}  // namespace traverse::diagnosis
