// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "archive_parts.h"

#include <algorithm>
#include <cmath>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr size_t kLongestLabel = 4096;
constexpr double kLongestPeriod_s = 1e9;
constexpr double kLargestOffset_s = 3600;
constexpr int32_t kFarthestCell = 1 << 30;

bool isPose(const Eigen::Isometry3d& pose)
{
  constexpr double kRounding = 1e-6;  // of a rotation that was kept in doubles
  const Eigen::Matrix3d R = pose.linear();
  return pose.matrix().allFinite() &&
         pose.translation().cwiseAbs().maxCoeff() <= geometry::kFarthest_m &&
         (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kRounding &&
         R.determinant() > 0;
}

void writePose(formats::ByteWriter& out, const Eigen::Isometry3d& pose)
{
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      out.f64(pose.matrix()(row, column));
    }
  }
}

Eigen::Isometry3d readPose(formats::ByteReader& in)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      pose.matrix()(row, column) = in.f64();
    }
  }
  if (!isPose(pose))
  {
    in.fail("a pose that is none");
  }
  return pose;
}

double readWithin(formats::ByteReader& in, double least, double most)
{
  const double value = in.f64();
  if (!(value >= least && value <= most))
  {
    in.fail("a number out of its range");
  }
  return value;
}

void readSensor(formats::ByteReader& in, State& state, size_t number)
{
  const std::string label = in.str(kLongestLabel);
  Sensor& sensor = state.sensors.obtain(label, state.cells.region().width());
  if (state.sensors.all().size() != number + 1)
  {
    in.fail("a sensor that is there twice");
  }
  sensor.newest = readTime(in);
  sensor.period_s = readWithin(in, 0, kLongestPeriod_s);
  sensor.clouds = in.u64();
  sensor.refused = in.u64();
  sensor.last_hash = in.u64();
  sensor.repeats = in.u32();
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    sensor.repeats_at[i] = readWithin(in, -geometry::kFarthest_m, geometry::kFarthest_m);
  }
  sensor.clock_offset_s = readWithin(in, -kLargestOffset_s, kLargestOffset_s);
}
}  // namespace

poses::TimeNs readTime(formats::ByteReader& in)
{
  const poses::TimeNs time = in.i64();
  if (time < -kLastTime || time > kLastTime)
  {
    in.fail("a time that is none");
  }
  return time;
}

std::string gridBytes(const State& state)
{
  formats::ByteWriter out;
  const geometry::CellRect& region = state.cells.region();
  out.i32(state.lattice.cell_mm);
  out.i32(region.width());
  out.i32(region.min.x);
  out.i32(region.min.y);
  out.i64(state.now);
  out.i64(state.forgot_at);
  out.u8(static_cast<uint8_t>(state.robot.has_value()));
  const poses::StampedPose robot = state.robot.value_or(poses::StampedPose{});
  out.i64(robot.time);
  writePose(out, robot.T_map_base);
  return out.take();
}

void readGrid(formats::ByteReader in, State& state)
{
  const int32_t cell_mm = in.i32();
  const int32_t edge = in.i32();
  if (cell_mm != state.lattice.cell_mm || edge != state.cells.region().width())
  {
    in.fail("cells or a region of another size than the options say");
  }
  const geometry::CellIndex first{in.i32(), in.i32()};
  for (const int32_t at : {first.x, first.y})
  {
    if (at < -kFarthestCell || at > kFarthestCell)
    {
      in.fail("a region that is too far out");
    }
  }
  state.cells.moveTo({first.x + edge / 2, first.y + edge / 2});
  state.now = readTime(in);
  state.forgot_at = readTime(in);
  const uint8_t has_robot = in.u8();
  poses::StampedPose robot;
  robot.time = readTime(in);
  robot.T_map_base = readPose(in);
  in.expectEnd();
  if (has_robot > 1)
  {
    in.fail("neither a robot nor none");
  }
  if (has_robot == 1)
  {
    state.robot = robot;
  }
}

std::string sensorBytes(const Sensors& sensors)
{
  formats::ByteWriter out;
  out.u32(static_cast<uint32_t>(sensors.all().size()));
  for (const Sensor& sensor : sensors.all())
  {
    out.str(std::string_view(sensor.label).substr(0, kLongestLabel));
    out.i64(sensor.newest);
    out.f64(sensor.period_s);
    out.u64(sensor.clouds);
    out.u64(sensor.refused);
    out.u64(sensor.last_hash);
    out.u32(sensor.repeats);
    for (const double at : sensor.repeats_at)
    {
      out.f64(at);
    }
    out.f64(sensor.clock_offset_s);
  }
  return out.take();
}

uint32_t sensorCount(formats::ByteReader in)
{
  const uint32_t count = in.u32();
  if (count > Sensors::kMost)
  {
    in.fail("more sensors than a map knows apart");
  }
  return count;
}

void readSensors(formats::ByteReader in, State& state)
{
  const uint32_t count = in.u32();
  for (uint32_t i = 0; i < count; ++i)
  {
    readSensor(in, state, i);
  }
  in.expectEnd();
}
}  // namespace traverse::multi_lidar_grid
