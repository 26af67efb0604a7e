// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "division.h"
#include "fan_trace.h"
#include "mapper_work.h"
#include "silent_beams.h"

#include <traverse/points/range_image.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace traverse::multi_lidar_grid
{
namespace
{
using geometry::CellIndex;
using geometry::CellRect;
using layers::OccupancyState;

constexpr double kMm = geometry::kMillimetresPerMetre;

OccupancyState stateOf(Returns returns)
{
  switch (returns)
  {
    case Returns::obstacle:
      return OccupancyState::obstacle;
    case Returns::overhang:
      return OccupancyState::overhang;
    case Returns::ground:
      return OccupancyState::free;
    default:
      return OccupancyState::unknown;
  }
}

/** A height over the ground, or over the column's lowest return. */
uint8_t heightSteps(const Column& column, int32_t height_mm)
{
  const int32_t zero = column.ground == Column::kNoGround ? column.low : column.ground;
  const double steps = (height_mm - zero) / (kFreeStep_m * kMm);
  return static_cast<uint8_t>(std::clamp(steps, 0.0, 255.0));
}

void setHits(const Column& column, Returns returns, UnitCell& cell)
{
  const bool is_obstacle = cell.state == OccupancyState::obstacle;
  cell.up_to = is_obstacle ? heightSteps(column, column.hits_to) : uint8_t{0};
  const uint8_t hangs = returns == Returns::hanging ? kHangs : 0;
  cell.hit_from = is_obstacle ? heightSteps(column, column.above) : hangs;
}

CellRect around(CellIndex a)
{
  return {a, {a.x + 1, a.y + 1}};
}
}  // namespace

UnitMapper::Work::Work(const Params& params, const geometry::Vehicle& vehicle) :
    rules(params, vehicle),
    lattice(latticeOf(params)),
    ground(latticeOf(params), regionEdge(params), vehicle)
{
}

void UnitMapper::Work::locatePoints(
    const Cloud& cloud, const SensorParams& sensor, const CellRect& region)
{
  const points::Scan& scan = cloud.scan;
  frame = frameOf(cloud, sensor, region, rules);
  points.resize(std::min({scan.x.size(), scan.y.size(), scan.z.size()}));
  const bool has_times = scan.time_s.size() >= points.size;
  locate(
      frame,
      {scan.x.data(), scan.y.data(), scan.z.data(), has_times ? scan.time_s.data() : nullptr,
       points.size},
      points);
}

/** The ground in the region, and from where on a return is an obstacle to this sensor. A level
 * scanner meets no ground: whatever it meets stands up to its beam. */
void UnitMapper::Work::findGround(const Cloud& cloud, const CellRect& region)
{
  const GroundReference::Stand stand = {
      cloud.path.pose(), cloud.stamp, cloud.sensor_bit, frame.zero_mm / kMm};
  is_level = fans.isLevelRow() && (cloud.scan.image == nullptr || cloud.scan.image->rows <= 1);
  if (!is_level && ground.isDue(stand))
  {
    ground.add(points, region, stand);
  }
  local_ground = &ground.local(region, stand, is_level);
  obstacle_mm = rules.obstacle_mm;
  const Eigen::Vector3d origin = cloud.path.originAt(0);
  const CellIndex cell = {
      static_cast<int32_t>(std::floor((origin.x() * kMm - frame.min_x_mm) / rules.cell_mm)),
      static_cast<int32_t>(std::floor((origin.y() * kMm - frame.min_y_mm) / rules.cell_mm))};
  const CellRect here = {{0, 0}, {frame.edge, frame.edge}};
  if (is_level && here.contains(cell))
  {
    const double beam_mm =
        origin.z() * kMm - frame.zero_mm - local_ground->heightAt(cell.x, cell.y) * kMm;
    obstacle_mm =
        beam_mm > 0 ? std::min(obstacle_mm, static_cast<int32_t>(beam_mm / 2)) : obstacle_mm;
  }
}

CellIndex UnitMapper::Work::cellOf(int32_t cell, const CellRect& region) const
{
  return {region.min.x + cell % frame.edge, region.min.y + cell / frame.edge};
}

void UnitMapper::Work::judgeCells(UnitMap& map)
{
  const CellRect& region = map.cells.region();
  columns.collect(points, static_cast<size_t>(frame.edge) * static_cast<size_t>(frame.edge));
  for (Column& column : columns.columns())
  {
    if (rules.cells == CellRule::standard)
    {
      const float ground_m =
          local_ground->heightAt(column.cell % frame.edge, column.cell / frame.edge);
      const bool is_known = std::abs(ground_m) < 1e6F;
      column.ground =
          is_known ? static_cast<int32_t>(std::lround(ground_m * 1000)) : Column::kNoGround;
    }
    setLimits(rules, obstacle_mm, column);
  }
  columns.compare(points);
  for (const Column& column : columns.columns())
  {
    const CellIndex index = cellOf(column.cell, region);
    UnitCell& cell = map.cells.at(index);
    const Returns returns = judge(rules, column);
    cell.state = stateOf(returns);
    setHits(column, returns, cell);
    cell.returns = static_cast<uint8_t>(std::min(column.count - column.count_high, 255U));
    map.touched = bounding(map.touched, around(index));
  }
}

void UnitMapper::Work::traceFans(const Cloud& cloud, const SensorParams& sensor, UnitMap& map)
{
  const CellRect& region = map.cells.region();
  const FanScene scene = {
      rules, *local_ground, columns, region, static_cast<float>(sensor.range_m), is_level};
  FanTrace trace(scene, map);
  float reach_m = 0;
  origins.assign(static_cast<size_t>(fans.count()), localOrigin(cloud, frame, 0));
  for (int32_t fan = 0; fan < fans.count(); ++fan)
  {
    const std::span<const FanBeam> beams = fans.beams(static_cast<size_t>(fan));
    if (beams.empty())
    {
      continue;
    }
    Eigen::Vector3f& origin = origins[static_cast<size_t>(fan)];
    origin = localOrigin(cloud, frame, fans.time_s(fan));
    trace.trace(origin, fans, fan, beams);
    for (const FanBeam& beam : beams)
    {
      reach_m = std::max(reach_m, beam.reach_m);
    }
  }
  reach_m = std::min(reach_m, scene.range_m) + rules.cell_m();
  for (const Eigen::Vector3d& p : cloud.path.origins())
  {
    const auto cell = [&](double metres)
    { return static_cast<int32_t>(std::floor(metres * kMm / rules.cell_mm)); };
    const CellRect seen = {
        {std::max(cell(p.x() - reach_m), region.min.x),
         std::max(cell(p.y() - reach_m), region.min.y)},
        {std::min(cell(p.x() + reach_m) + 1, region.max.x),
         std::min(cell(p.y() + reach_m) + 1, region.max.y)}};
    map.touched = bounding(map.touched, seen);
  }
}

void UnitMapper::Work::tracePaper(const Cloud& cloud, UnitMap& map)
{
  const Eigen::Vector3d origin = cloud.path.originAt(0);
  const CellIndex stand =
      lattice.cellOf(geometry::toMillimetres(origin.x()), geometry::toMillimetres(origin.y()));
  const double steps = rules.robot_mm / (kFreeStep_m * kMm);
  const CellRect seen =
      paper.trace(frame, stand, static_cast<uint8_t>(std::min(steps, 255.0)), map);
  map.touched = bounding(map.touched, seen);
}

void UnitMapper::Work::finish(UnitMap& map) const
{
  for (const Column& column : columns.columns())
  {
    UnitCell& cell = map.cells.at(cellOf(column.cell, map.cells.region()));
    cell.hit_from = cell.state == OccupancyState::obstacle ? cell.hit_from : uint8_t{0};
  }
}

UnitMapper::UnitMapper(const Params& params, const geometry::Vehicle& vehicle) :
    work_(std::make_unique<Work>(params, vehicle))
{
}

UnitMapper::UnitMapper(const UnitMapper& other) : work_(std::make_unique<Work>(*other.work_)) {}

UnitMapper::UnitMapper(UnitMapper&& other) noexcept = default;

UnitMapper& UnitMapper::operator=(UnitMapper other) noexcept
{
  std::swap(work_, other.work_);
  return *this;
}

UnitMapper::~UnitMapper() = default;

UnitMapper::Counts UnitMapper::make(
    const Cloud& cloud, const SensorParams& sensor, CellIndex centre, UnitMap& map)
{
  Work& work = *work_;
  map.cells.fill(map.touched, UnitCell{});
  map.touched = {};
  map.cells.moveTo(centre);
  map.stamp = cloud.stamp;
  const CellRect& region = map.cells.region();

  work.origins.clear();
  work.locatePoints(cloud, sensor, region);
  if (work.rules.needsGround())
  {
    work.fans.collect(cloud.scan, work.points);
    work.ground.moveTo(centre);
    work.findGround(cloud, region);
  }
  else
  {
    work.obstacle_mm = work.rules.obstacle_mm;
  }
  work.judgeCells(map);
  if (work.rules.trace == TraceRule::paper)
  {
    work.tracePaper(cloud, map);
  }
  else
  {
    addSilentBeams(cloud, sensor, work.rules, work.fans);
    work.fans.sort();
    work.traceFans(cloud, sensor, map);
  }
  work.finish(map);
  const uint64_t size = work.points.size;
  return {work.points.inside, size - work.points.inside - work.points.bad, work.points.bad};
}

double UnitMapper::groundAt(CellIndex cell) const
{
  return work_->ground.heightAt(cell);
}
}  // namespace traverse::multi_lidar_grid
