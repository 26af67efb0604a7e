// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// A KITTI cloud of 124,668 points into a 150 x 150 m grid of 0.2 m cells: ours with pose, sums and
// classes; MRPT's height map with the same points (heights only); the slow and obvious way. And
// ours where the map has become large. Each checks its answer first.
#include <traverse/traversability_grid/traversability_grid.h>

#include <mrpt/maps/CHeightGridMap2D.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <zlib.h>

namespace
{
using namespace traverse;
using namespace traverse::traversability_grid;

const geometry::Vehicle kCar;
constexpr double kHalf_m = 75;
const std::filesystem::path kCloud =
    std::filesystem::path(TRAVERSE_DATA_DIR) / "kitti-odo00-labelled/full_resolution/000000.bin.gz";

void require(bool holds, const char* what)
{
  if (!holds)
  {
    throw std::runtime_error(what);
  }
}

points::ScanBuffer readCloud()
{
  points::ScanBuffer scan;
  gzFile in = gzopen(kCloud.c_str(), "rb");
  std::array<float, 4> p{};
  while (in != nullptr && gzread(in, p.data(), sizeof p) == static_cast<int>(sizeof p))
  {
    scan.x.push_back(p[0]);
    scan.y.push_back(p[1]);
    scan.z.push_back(p[2]);
  }
  gzclose(in);
  require(scan.size() > 120'000, "the cloud's size");
  return scan;
}

const points::ScanBuffer& cloud()
{
  static const points::ScanBuffer kScan = readCloud();
  return kScan;
}

/** A pose of no round numbers, so that nothing is saved. */
Eigen::Isometry3d at(double x)
{
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  T.translation() = Eigen::Vector3d(x + 0.123, 0.456, 1.73);
  return T;
}

using NaiveCell = std::pair<uint32_t, Class>;  // points, class

/** All of a cell's points, as the paper has them; two passes in double. */
NaiveCell classifyNaively(const std::vector<Eigen::Vector3d>& points, const Classifier& classify)
{
  Features f;
  f.n = points.size();
  const auto n = static_cast<double>(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
  {
    mean += p / n;
  }
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points)
  {
    const Eigen::Vector3d d = p - mean;
    f.deviation_m = std::max(f.deviation_m, std::abs(d.z()));
    scatter += d * d.transpose();
  }
  f.variance_m2 = scatter(2, 2) / n;
  const double determinant = scatter(0, 0) * scatter(1, 1) - scatter(0, 1) * scatter(0, 1);
  const double trace = scatter(0, 0) + scatter(1, 1);
  f.has_plane = determinant > 1e-9 * trace * trace;
  if (f.has_plane)
  {
    f.slope_x = (scatter(0, 2) * scatter(1, 1) - scatter(1, 2) * scatter(0, 1)) / determinant;
    f.slope_y = (scatter(1, 2) * scatter(0, 0) - scatter(0, 2) * scatter(0, 1)) / determinant;
  }
  return {static_cast<uint32_t>(points.size()), classify(f)};
}

using NaiveMap = std::unordered_map<uint64_t, NaiveCell>;

NaiveMap naiveMap(const points::ScanBuffer& scan, const Eigen::Isometry3d& T, const Params& params)
{
  const auto near = [&](double p, double robot) {
    return static_cast<int64_t>(std::floor(p / 200)) - static_cast<int64_t>(std::floor(robot * 5));
  };
  std::unordered_map<uint64_t, std::vector<Eigen::Vector3d>> cells;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    const Eigen::Vector3d mm(
        std::round(p.x() * 1000), std::round(p.y() * 1000), std::round(p.z() * 1000));
    const int64_t column = near(mm.x(), T.translation().x()) + 375;
    const int64_t row = near(mm.y(), T.translation().y()) + 375;
    if (column >= 0 && column < 750 && row >= 0 && row < 750 &&
        std::abs(p.z() - T.translation().z()) <= 30)
    {
      cells[static_cast<uint64_t>(row * 750 + column)].push_back(mm / 1000);
    }
  }
  const Classifier classify(params);
  NaiveMap map;
  for (const auto& [cell, points] : cells)
  {
    map[cell] = classifyNaively(points, classify);
  }
  return map;
}

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
