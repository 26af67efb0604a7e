// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A cloud of 32 beams (nuScenes) into 100 x 100 m of 0.2 m cells: ours, its parts and the paper's
// rules, beside MRPT's 2-D and 3-D grids and OctoMap with the same cloud; the safety buffer of
// 750 x 750 cells beside OpenCV's distance transforms, where its headers are; a 1 m move. Each
// checks its answer first.
#include "buffer_by_opencv.h"
#include "nuscenes_clouds.h"

#include <traverse/layers/safety_buffer.h>
#include <traverse/multi_lidar_grid/multi_lidar_grid.h>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/COccupancyGridMap3D.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <octomap/octomap.h>

namespace
{
using namespace traverse;
using namespace traverse::multi_lidar_grid;
using traverse::bench::cloud;
using traverse::bench::kFolder;
using traverse::bench::kMount_m;
using traverse::bench::require;

const geometry::Vehicle kCar;

const poses::PoseTrack& standing()
{
  static const poses::PoseTrack kTrack =
      poses::PoseTrack::constant(Eigen::Isometry3d(Eigen::Translation3d(0.123, 0.456, 0)));
  return kTrack;
}

Params paper()
{
  Params params;
  params.cells = CellRule::paper;
  params.trace = TraceRule::paper;
  return params;
}

size_t countOf(const UnitMap& map, layers::OccupancyState state)
{
  size_t n = 0;
  map.cells.forEach([&](geometry::CellIndex, const UnitCell& cell)
                    { n += cell.state == state ? 1 : 0; });
  return n;
}

void unitMaps(benchmark::State& bench, const Params& params)
{
  UnitMapper mapper(params, kCar);
  UnitMap map(static_cast<int32_t>(std::lround(params.window_m / params.cell_size_m)));
  const points::Scan scan = cloud(0).view();
  const Cloud placed = {scan, 0, 1, SensorPath::along(scan, 0, standing()).value()};
  const SensorParams sensor = sensorParams(params, "roof");
  require(mapper.make(placed, sensor, {0, 2}, map).points > 20'000, "points in cells");
  require(countOf(map, layers::OccupancyState::obstacle) > 300, "obstacles");
  require(countOf(map, layers::OccupancyState::free) > 3'000, "free cells");
  for ([[maybe_unused]] auto _ : bench)
  {
    mapper.make(placed, sensor, {0, 2}, map);
  }
}

/** A state after some clouds, 0.1 s apart. */
State mapOf(const Params& params, int64_t clouds)
{
  State state(params, kCar);
  for (int64_t i = 0; i < clouds; ++i)
  {
    points::Scan scan = cloud(static_cast<size_t>(i)).view();
    scan.stamp = i * 100'000'000;
    require(update(state, scan, standing(), params, kCar).inserted, "a cloud");
  }
  return state;
}

/** Unit map and accumulation. */
void oursUpdate(benchmark::State& bench)
{
  int64_t i = 10;
  State state = mapOf({}, i);
  for ([[maybe_unused]] auto _ : bench)
  {
    points::Scan scan = cloud(static_cast<size_t>(i)).view();
    scan.stamp = i++ * 100'000'000;
    update(state, scan, standing(), {}, kCar);
  }
}

/** One layer of 750 x 750 small cells, 1 m on and back. */
void oursMove(benchmark::State& bench)
{
  layers::WrappedGrid<uint8_t> grid(750);
  grid.fill(grid.region(), 1);
  grid.moveTo({5, 0});
  require(*grid.get({379, 0}) == 0 && *grid.get({374, 0}) == 1, "what came in is empty");
  int32_t x = 5;
  for ([[maybe_unused]] auto _ : bench)
  {
    x = 5 - x;
    grid.moveTo({x, 0});
    benchmark::DoNotOptimize(grid.at({x, 0}));
  }
}

/** The accumulated map's states, 750 x 750. */
const std::vector<uint8_t>& states()
{
  static const std::vector<uint8_t> kStates = []
  {
    Params params;
    params.window_m = 150;
    std::vector<uint8_t> all;
    mapOf(params, 4).cells.forEach([&](geometry::CellIndex, const Cell& cell)
                                   { all.push_back(static_cast<uint8_t>(cell.state)); });
    require(all.size() == 750 * 750, "cells");
    require(std::count(all.begin(), all.end(), 2) > 1'000, "obstacles of the map");
    return all;
  }();
  return kStates;
}

void buffers(benchmark::State& bench, layers::StripRule strip)
{
  const std::vector<uint8_t>& cells = states();
  for ([[maybe_unused]] auto _ : bench)
  {
    benchmark::DoNotOptimize(layers::safetyBuffer(cells, 750, {.strip = strip}));
  }
}

#ifdef TRAVERSE_BENCH_OPENCV
void peerOpenCvBuffer(benchmark::State& bench)
{
  const std::vector<uint8_t>& cells = states();
  const bench::OpenCvBuffer peer = bench::bufferByOpenCv(cells, 750);
  const std::vector<uint8_t> mine =
      layers::safetyBuffer(cells, 750, {.strip = layers::StripRule::paper});
  size_t others = 0;
  size_t strip = 0;
  for (size_t i = 0; i < mine.size(); ++i)
  {
    others += mine[i] == peer.zoneOf(i, cells[i]) ? 0 : 1;
    strip += mine[i] == 3 ? 1 : 0;
  }
  require(strip > 100 && others * 10'000 <= mine.size(), "zones by OpenCV");
  for ([[maybe_unused]] auto _ : bench)
  {
    benchmark::DoNotOptimize(bench::bufferByOpenCv(cells, 750));
  }
}
#endif

/** The nearest return between the obstacle height and the vehicle's, per 0.2 degrees. */
mrpt::obs::CObservation2DRangeScan slice()
{
  constexpr size_t kRays = 1800;
  mrpt::obs::CObservation2DRangeScan scan;
  scan.aperture = static_cast<float>(2 * M_PI);
  scan.maxRange = 80;
  scan.sensorPose = mrpt::poses::CPose3D(0, 0, kMount_m, 0, 0, 0);
  scan.resizeScanAndAssign(kRays, 80, false);
  const points::ScanBuffer& points = cloud(0);
  for (size_t i = 0; i < points.size(); ++i)
  {
    const double range = std::hypot(points.x[i], points.y[i]);
    if (points.z[i] > 0.25F && points.z[i] < 2 && range < 80)
    {
      const double turn = (std::atan2(points.y[i], points.x[i]) + M_PI) / (2 * M_PI);
      const size_t ray = std::min(static_cast<size_t>(turn * kRays), kRays - 1);
      scan.setScanRange(ray, std::min(scan.getScanRange(ray), static_cast<float>(range)));
      scan.setScanRangeValidity(ray, true);
    }
  }
  return scan;
}

/** A slice only: one beam of the 32, as it were. */
void peerMrptGrid2D(benchmark::State& bench)
{
  mrpt::maps::COccupancyGridMap2D map(-50, 50, -50, 50, 0.2F);
  map.insertionOptions.mapAltitude = 0;
  map.insertionOptions.useMapAltitude = false;
  const mrpt::obs::CObservation2DRangeScan scan = slice();
  map.insertObservation(scan);
  size_t free = 0;
  for (unsigned x = 0; x < map.getSizeX(); ++x)
  {
    for (unsigned y = 0; y < map.getSizeY(); ++y)
    {
      free += map.getCell(static_cast<int>(x), static_cast<int>(y)) > 0.51F ? 1 : 0;
    }
  }
  require(free > 3'000, "free cells of the 2-D grid");
  for ([[maybe_unused]] auto _ : bench)
  {
    map.insertObservation(scan);
  }
}

void peerMrptGrid3D(benchmark::State& bench)
{
  mrpt::maps::COccupancyGridMap3D map({-50, -50, -3}, {50, 50, 5}, 0.2F);
  mrpt::maps::CSimplePointsMap points;
  const points::ScanBuffer& scan = cloud(0);
  for (size_t i = 0; i < scan.size(); ++i)
  {
    points.insertPointFast(scan.x[i], scan.y[i], scan.z[i]);
  }
  const mrpt::math::TPoint3D sensor(0, 0, kMount_m);
  map.insertPointCloud(sensor, points, 80);
  size_t hits = 0;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    hits += map.getFreenessByPos(scan.x[i], scan.y[i], scan.z[i]) < 0.5F ? 1 : 0;
  }
  require(hits * 2 > scan.size(), "hits of the 3-D grid");
  for ([[maybe_unused]] auto _ : bench)
  {
    map.insertPointCloud(sensor, points, 80);
  }
}

void peerOctoMap(benchmark::State& bench)
{
  octomap::OcTree tree(0.2);
  octomap::Pointcloud points;
  const points::ScanBuffer& scan = cloud(0);
  for (size_t i = 0; i < scan.size(); ++i)
  {
    points.push_back(scan.x[i], scan.y[i], scan.z[i]);
  }
  const octomap::point3d sensor(0, 0, static_cast<float>(kMount_m));
  tree.insertPointCloud(points, sensor, 80);
  require(tree.getNumLeafNodes() > 10'000, "leaves of the octree");
  for ([[maybe_unused]] auto _ : bench)
  {
    tree.insertPointCloud(points, sensor, 80);
  }
}
}  // namespace

BENCHMARK_CAPTURE(unitMaps, default, Params{})->Name("ours")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(unitMaps, paper, paper())->Name("oursPaper")->Unit(benchmark::kMicrosecond);
BENCHMARK(oursUpdate)->Unit(benchmark::kMicrosecond);
BENCHMARK(oursMove)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(buffers, default, layers::StripRule::standard)
    ->Name("oursBuffer")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(buffers, paper, layers::StripRule::paper)
    ->Name("oursBufferPaper")
    ->Unit(benchmark::kMicrosecond);
#ifdef TRAVERSE_BENCH_OPENCV
BENCHMARK(peerOpenCvBuffer)->Unit(benchmark::kMicrosecond);
#endif
BENCHMARK(peerMrptGrid2D)->Unit(benchmark::kMicrosecond);
BENCHMARK(peerMrptGrid3D)->Unit(benchmark::kMicrosecond);
BENCHMARK(peerOctoMap)->Unit(benchmark::kMicrosecond);

int main(int argc, char** argv)
{
  if (!std::filesystem::exists(kFolder))
  {
    std::printf("SKIPPED: real data is missing: %s\n", kFolder.c_str());
    return EXIT_SUCCESS;
  }
#ifndef TRAVERSE_BENCH_OPENCV
  std::printf("SKIPPED: OpenCV's headers are missing, so its buffer is not timed\n");
#endif
  try
  {
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return EXIT_SUCCESS;
  }
  catch (const std::exception& e)
  {
    std::printf("WRONG: %s\n", e.what());
    return EXIT_FAILURE;
  }
}
