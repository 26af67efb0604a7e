// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// One real VLP-16 turn to points: our decoder beside MRPT's own, in one run. Ours yields twice the
// points.

#include <traverse/observations/to_scan.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/serialization/CArchive.h>

#include <benchmark/benchmark.h>

#include <stdexcept>

namespace
{
using mrpt::obs::CObservationVelodyneScan;

constexpr size_t kValidReturns = 22591;
constexpr size_t kMrptReturns = 11305;

const CObservationVelodyneScan& realTurn()
{
  static const auto kTurn = []
  {
    mrpt::io::CFileGZInputStream file("/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog");
    return std::dynamic_pointer_cast<CObservationVelodyneScan>(
        mrpt::serialization::archiveFrom(file).ReadObject());
  }();
  return *kTurn;
}

void expectPoints(size_t got, size_t expected)
{
  if (got != expected)
  {
    throw std::runtime_error("the decoder under test gives a wrong answer");
  }
}

void ours(benchmark::State& state)
{
  expectPoints(traverse::observations::toScan(realTurn(), {}).decoded.scan.size(), kValidReturns);
  for ([[maybe_unused]] auto _ : state)
  {
    benchmark::DoNotOptimize(traverse::observations::toScan(realTurn(), {}));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kValidReturns));
}

void peerMrpt(benchmark::State& state)
{
  CObservationVelodyneScan scan = realTurn();
  scan.generatePointCloud();
  expectPoints(scan.point_cloud.x.size(), kMrptReturns);
  for ([[maybe_unused]] auto _ : state)
  {
    scan.generatePointCloud();
    benchmark::DoNotOptimize(scan.point_cloud.x.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kMrptReturns));
}
}  // namespace

BENCHMARK(ours)->Unit(benchmark::kMicrosecond);
BENCHMARK(peerMrpt)->Unit(benchmark::kMicrosecond);
BENCHMARK_MAIN();
