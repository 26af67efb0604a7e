// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A KITTI cloud of 124,668 points into a 150 x 150 m grid of 0.2 m cells: ours with pose, sums and
// classes; the same with the ground estimate, with a label for each point, and by parts; MRPT's
// height map with the same points (heights only); the slow and obvious way. And ours where the map
// has become large. Each checks its answer first.
#include "kitti_cloud.h"
#include "naive_grid.h"

#include <traverse/traversability_grid/point_labels.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <mrpt/maps/CHeightGridMap2D.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;
using namespace traverse::bench;

const geometry::Vehicle kCar;

/** The paper's reading: all of a cell's heights, which is also what the naive way has. */
Params paper(Mode mode, Extent extent)
{
  Params params;
  params.classifier = ClassifierKind::paper;
  params.mode = mode;
  params.extent = extent;
  params.window_m = 2 * kHalf_m;
  params.ignore_overhangs = false;
  return params;
}

/** Our map of the one cloud has the naive way's count in every cell, and its class in all but those
 * where doubles round a value to the other side of a limit. */
void checkOurs()
{
  const Params params = paper(Mode::single_cloud, Extent::rolling);
  State state = makeState(params, kCar);
  update(state, cloud().view(), at(0), params, kCar);
  const layers::LayerSet set = layerSet(state, params, kCar);
  const auto& codes = std::get<std::vector<uint8_t>>(set.find("traversability_class")->data);
  const auto& counts = std::get<std::vector<uint32_t>>(set.find("point_count")->data);
  size_t others = 0;
  const NaiveMap naive = naiveMap(cloud(), at(0), params);
  require(naive.size() == state.occupied && naive.size() > 15'000, "occupied cells");
  for (const auto& [cell, expected] : naive)
  {
    require(counts[cell] == expected.first, "points of a cell");
    others += codes[cell] == static_cast<uint8_t>(expected.second) ? 0 : 1;
  }
  require(others * 1000 <= naive.size(), "classes");
}

/** The time of a cloud at the last place of a drive, after a cloud at each of its places. */
void updates(benchmark::State& bench, const Params& params, const std::vector<double>& drive)
{
  State map = makeState(params, kCar);
  for (const double x : drive)
  {
    update(map, cloud().view(), at(x), params, kCar);
  }
  require(map.occupied > drive.size() * 8'000, "cells of the drive");
  uint64_t points = 0;
  for ([[maybe_unused]] auto _ : bench)
  {
    points += update(map, cloud().view(), at(drive.back()), params, kCar).points;
  }
  require(points > static_cast<uint64_t>(bench.iterations()) * 120'000, "points added");
}

/** A rolling map at one place, as the peers have it. */
void ours(benchmark::State& bench)
{
  updates(bench, paper(Mode::accumulated, Extent::rolling), {0});
}

/** The map forgets the cloud before. */
void oursSingleCloud(benchmark::State& bench)
{
  updates(bench, paper(Mode::single_cloud, Extent::rolling), {0});
}

/** A map that never forgets, with a cloud at the same place only. */
void oursGrowingNew(benchmark::State& bench)
{
  updates(bench, paper(Mode::accumulated, Extent::growing), {500});
}

/** The same after 500 m of driving, a cloud every 20 m: its cells have other clouds' points too, as
 * those of any drive. */
void oursAfter500m(benchmark::State& bench)
{
  std::vector<double> drive;
  for (int i = 0; i <= 25; ++i)
  {
    drive.push_back(20.0 * i);
  }
  updates(bench, paper(Mode::accumulated, Extent::growing), drive);
}

/** classifier = default. The cloud's sensor is 1.73 m above the ground, as at() has it. */
Params withGround()
{
  Params params;
  params.mode = Mode::accumulated;
  params.extent = Extent::rolling;
  params.window_m = 2 * kHalf_m;
  return params;
}

geometry::Vehicle mounted()
{
  geometry::Vehicle car;
  car.base_height_m = 1.73;
  return car;
}

State mapWithGround()
{
  State map = makeState(withGround(), mounted());
  update(map, cloud().view(), at(0), withGround(), mounted());
  const auto labels = labelsOfLastScan(map, cloud().view(), at(0), withGround());
  const auto ground = std::count(labels.begin(), labels.end(), PointLabel::ground);
  require(ground > 40'000 && ground < 100'000, "points of the ground");
  return map;
}

/** With the ground estimate, which `ours` does without. */
void oursDefault(benchmark::State& bench)
{
  State map = mapWithGround();
  for ([[maybe_unused]] auto _ : bench)
  {
    update(map, cloud().view(), at(0), withGround(), mounted());
  }
}

/** And the label of every point. */
void oursDefaultLabels(benchmark::State& bench)
{
  State map = mapWithGround();
  for ([[maybe_unused]] auto _ : bench)
  {
    update(map, cloud().view(), at(0), withGround(), mounted());
    benchmark::DoNotOptimize(labelsOfLastScan(map, cloud().view(), at(0), withGround()));
  }
}

/** The labels only. */
void partLabels(benchmark::State& bench)
{
  const State map = mapWithGround();
  for ([[maybe_unused]] auto _ : bench)
  {
    benchmark::DoNotOptimize(labelsOfLastScan(map, cloud().view(), at(0), withGround()));
  }
}

/** A judge that was given the map's cells. */
void addCells(Judge& judge, const State& map)
{
  const geometry::CellRect window = map.window.value();
  judge.begin(withGround(), mounted(), map.lattice, window, map.driven);
  const SlabReading reading = slabReading(map, withGround(), mounted());
  for (uint32_t number = 0; number < map.scan.size(); ++number)
  {
    judge.add(
        map.scan.cell(number),
        featuresOf(map.slabs, map.slabs.get(map.cells.at(map.touched[number]).slabs), reading));
  }
}

/** Steps 4 and 5 up to the ground estimate: features, and each cell by itself. */
void partFeatures(benchmark::State& bench)
{
  const State map = mapWithGround();
  Judge judge;
  for ([[maybe_unused]] auto _ : bench)
  {
    addCells(judge, map);
  }
  require(judge.judgements().size() == map.scan.size(), "judgements");
}

/** The same with the ground estimate and the cells judged against it. */
void partFeaturesAndGround(benchmark::State& bench)
{
  const State map = mapWithGround();
  Judge judge;
  for ([[maybe_unused]] auto _ : bench)
  {
    addCells(judge, map);
    judge.finish([](size_t /*i*/, int64_t /*floor_mm*/) { return Features(); });
  }
  require(judge.judgements().size() == map.scan.size(), "judgements");
}

void insertAll(mrpt::maps::CHeightGridMap2D& map, const Eigen::Isometry3d& T)
{
  const points::ScanBuffer& scan = cloud();
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    map.insertIndividualPoint(p.x(), p.y(), p.z());
  }
}

/** Heights are plausible: those of our cells within a slab's height in nearly all. */
void checkHeightMap(const mrpt::maps::CHeightGridMap2D& map)
{
  const Params params = paper(Mode::single_cloud, Extent::rolling);
  State state = makeState(params, kCar);
  update(state, cloud().view(), at(0), params, kCar);
  require(
      std::abs(
          static_cast<double>(map.countObservedCells()) / static_cast<double>(state.occupied) - 1) <
          0.1,
      "cells of the height map");
  size_t near = 0;
  const SlabReading reading = slabReading(state, params, kCar);
  for (uint32_t number = 0; number < state.scan.size(); ++number)
  {
    const geometry::CellIndex c = state.scan.cell(number);
    const auto* cell = map.cellByPos(state.lattice.centre_m(c.x), state.lattice.centre_m(c.y));
    const Features f = featuresOf(
        state.slabs, state.slabs.get(state.cells.at(state.touched[number]).slabs), reading);
    near += cell != nullptr && cell->w > 0 && std::abs(cell->h - f.mean_m) < 0.5 ? 1 : 0;
  }
  require(near * 10 > state.scan.size() * 9, "heights of the height map");
}

void peerMrptHeightGrid(benchmark::State& bench)
{
  mrpt::maps::CHeightGridMap2D map(
      mrpt::maps::CHeightGridMap2D::mrSimpleAverage, -kHalf_m, kHalf_m, -kHalf_m, kHalf_m, 0.2);
  insertAll(map, at(0));
  checkHeightMap(map);
  for ([[maybe_unused]] auto _ : bench)
  {
    insertAll(map, at(0));
  }
}

void naive(benchmark::State& bench)
{
  const Params params = paper(Mode::single_cloud, Extent::rolling);
  for ([[maybe_unused]] auto _ : bench)
  {
    benchmark::DoNotOptimize(naiveMap(cloud(), at(0), params));
  }
}
}  // namespace

BENCHMARK(ours)->Unit(benchmark::kMicrosecond);
BENCHMARK(oursSingleCloud)->Unit(benchmark::kMicrosecond);
BENCHMARK(oursGrowingNew)->Unit(benchmark::kMicrosecond);
BENCHMARK(oursAfter500m)->Unit(benchmark::kMicrosecond);
BENCHMARK(oursDefault)->Unit(benchmark::kMicrosecond);
BENCHMARK(oursDefaultLabels)->Unit(benchmark::kMicrosecond);
BENCHMARK(partFeatures)->Unit(benchmark::kMicrosecond);
BENCHMARK(partFeaturesAndGround)->Unit(benchmark::kMicrosecond);
BENCHMARK(partLabels)->Unit(benchmark::kMicrosecond);
BENCHMARK(peerMrptHeightGrid)->Unit(benchmark::kMicrosecond);
BENCHMARK(naive)->Unit(benchmark::kMicrosecond);

int main(int argc, char** argv)
{
  if (!std::filesystem::exists(kCloud))
  {
    std::printf("SKIPPED: real data is missing: %s\n", kCloud.c_str());
    return EXIT_SUCCESS;
  }
  try
  {
    checkOurs();
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
