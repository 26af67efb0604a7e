// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_trig.h"

#include <traverse/points/sweep.h>

#include <algorithm>
#include <utility>

namespace traverse::points
{
namespace
{
/** Elevation of the row's forward beam in the vehicle frame. */
double tilt(const Decoded& row)
{
  return geometry::arcSine(std::clamp(row.image.T_base_sensor.linear()(2, 0), -1.0, 1.0));
}

/** The row's pose without its tilt: what is left of the mount (heading and roll). */
Eigen::Isometry3d level(const Decoded& row)
{
  Eigen::Isometry3d T = row.image.T_base_sensor;
  T.linear() = T.linear() * poses::rotationBy(tilt(row), Eigen::Vector3d::UnitY());
  return T;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

void appendBeams(RangeImage& sweep, const RangeImage& row, float time_s)
{
  const Eigen::Isometry3d T_sweep_row = sweep.T_base_sensor.inverse() * row.T_base_sensor;
  for (size_t i = 0; i < row.size(); ++i)
  {
    const Eigen::Vector3d along = beamDirection(row.azimuth_rad[i], row.elevation_rad[i]);
    const bool hit = row.beam[i] == Beam::hit;
    // A hit is measured from the sweep's origin; what met nothing has no more than a direction.
    const Eigen::Vector3d seen = hit ? T_sweep_row * (along * static_cast<double>(row.range_m[i]))
                                     : T_sweep_row.linear() * along;
    const double norm = seen.norm();
    sweep.beam.push_back(row.beam[i]);
    sweep.range_m.push_back(hit ? static_cast<float>(norm) : row.range_m[i]);
    sweep.azimuth_rad.push_back(static_cast<float>(geometry::angleOf(seen.y(), seen.x())));
    sweep.elevation_rad.push_back(
        norm > 0 ? static_cast<float>(geometry::arcSine(std::clamp(seen.z() / norm, -1.0, 1.0)))
                 : 0.0F);
    sweep.time_s.push_back(time_s);
  }
}

void appendRow(Decoded& sweep, const Decoded& row, uint16_t ring)
{
  const float time_s = static_cast<float>(poses::secondsBetween(sweep.scan.stamp, row.scan.stamp));
  append(sweep.scan.x, row.scan.x);
  append(sweep.scan.y, row.scan.y);
  append(sweep.scan.z, row.scan.z);
  sweep.scan.time_s.resize(sweep.scan.size(), time_s);
  sweep.scan.ring.resize(sweep.scan.size(), ring);
  sweep.rejects += row.rejects;
  appendBeams(sweep.image, row.image, time_s);
}
}  // namespace

bool SweepCollector::continues(const Decoded& row) const
{
  const Decoded& last = rows_.back();
  const double pause_s = poses::secondsBetween(last.scan.stamp, row.scan.stamp);
  const double turned = tilt(row) - furthest_rad_;
  const bool turned_round = turned * direction_ < -limits_.min_turn_rad;
  return pause_s >= 0 && pause_s <= limits_.max_gap_s && !turned_round &&
         row.image.columns == last.image.columns && rows_.size() < limits_.max_rows;
}

std::optional<Decoded> SweepCollector::add(Decoded row)
{
  if (row.image.rows != 1)
  {
    return std::nullopt;
  }
  std::optional<Decoded> done;
  if (!rows_.empty() && !continues(row))
  {
    done = finish();
  }
  if (!rows_.empty() && direction_ == 0)
  {
    const double turned = tilt(row) - tilt(rows_.front());
    direction_ = std::abs(turned) < limits_.min_turn_rad ? 0 : (turned > 0 ? 1 : -1);
  }
  if (rows_.empty() || (tilt(row) - furthest_rad_) * direction_ > 0)
  {
    furthest_rad_ = tilt(row);
  }
  rows_.push_back(std::move(row));
  return done;
}

std::optional<Decoded> SweepCollector::finish()
{
  if (rows_.empty())
  {
    return std::nullopt;
  }
  std::vector<Decoded> rows = std::exchange(rows_, {});
  direction_ = 0;
  Decoded sweep;
  const Decoded& first = rows.front();
  sweep.scan.stamp = sweep.image.stamp = first.scan.stamp;
  sweep.scan.sensor_label = sweep.image.sensor_label = first.scan.sensor_label;
  sweep.scan.T_base_sensor = sweep.image.T_base_sensor = level(first);
  sweep.image.rows = static_cast<int>(rows.size());
  sweep.image.columns = first.image.columns;
  sweep.image.closes = first.image.closes;
  sweep.image.max_range_m = first.image.max_range_m;
  std::stable_sort(
      rows.begin(), rows.end(),
      [](const Decoded& a, const Decoded& b) { return tilt(a) < tilt(b); });
  for (size_t i = 0; i < rows.size(); ++i)
  {
    appendRow(sweep, rows[i], static_cast<uint16_t>(std::min<size_t>(i, 65535)));
  }
  return sweep;
}
}  // namespace traverse::points
