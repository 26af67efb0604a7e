// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause

// The experiment of paper 3 (classes of a robot's workspace by an HDL-32E) in simulated worlds,
// where the class of every cell is known: one run for each seed, a vehicle with the sensor driving
// through a random scene of all classes. The last line of stdout is one JSON object.
#include <traverse/evaluation/confusion.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <support/experiment.h>
#include <support/seed_runs.h>
#include <support/simulated_drive.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using Poses = SimulatedDrive::Poses;
using traversability_grid::ClassifierKind;

/** A map that takes the scans of a run. */
class MapOfRun
{
 public:
  MapOfRun(ClassifierKind classifier, Poses poses, const geometry::Vehicle& vehicle) :
      vehicle_(vehicle)
  {
    params_.classifier = classifier;
    if (poses == Poses::exact)
    {
      // The simulated sensor's own; the defaults leave room for errors of poses.
      params_.range_noise_m = 0.01;
      params_.angle_noise_deg = 0.01;
    }
    params_.extent = traversability_grid::Extent::growing;
    state_ = traversability_grid::makeState(params_, vehicle_);
  }

  void insert(const points::Scan& scan, const Eigen::Isometry3d& T_map_base)
  {
    traversability_grid::update(state_, scan, T_map_base, params_, vehicle_);
  }

  layers::LayerSet layerSet() const
  {
    return traversability_grid::layerSet(state_, params_, vehicle_);
  }

 private:
  geometry::Vehicle vehicle_;
  traversability_grid::Params params_;
  traversability_grid::State state_;
};

uint8_t lazyClass(float span_m)
{
  const std::array<float, 3> limits_m = {0.06F, 0.12F, 0.30F};
  const auto is_above = [span_m](float limit_m) { return span_m > limit_m; };
  return static_cast<uint8_t>(1 + std::count_if(limits_m.begin(), limits_m.end(), is_above));
}

/** What needs no method: the class that the span of heights in a cell suggests. */
layers::LayerSet lazyMap(layers::LayerSet map)
{
  const auto& low = std::get<std::vector<float>>(map.find("height_min")->data);
  const auto& high = std::get<std::vector<float>>(map.find("height_max")->data);
  for (layers::Layer& layer : map.layers)
  {
    if (layer.name == map.class_layer)
    {
      auto& classes = std::get<std::vector<uint8_t>>(layer.data);
      for (size_t i = 0; i < classes.size(); ++i)
      {
        classes[i] = lazyClass(high[i] - low[i]);
      }
    }
  }
  return map;
}

nlohmann::json countsOf(const layers::LayerSet& map, const layers::LayerSet& truth)
{
  evaluation::ConfusionParams params;
  params.returns_layer = "returns";
  const evaluation::Confusion confusion = evaluation::confusionOf(map, truth, params);
  nlohmann::json rows = nlohmann::json::array();
  for (uint8_t of = 1; of <= 4; ++of)
  {
    nlohmann::json row = nlohmann::json::array();
    for (uint8_t found = 0; found <= 4; ++found)
    {
      row.push_back(confusion.cells(of, found));
    }
    rows.push_back(row);
  }
  return rows;
}

nlohmann::json run(uint64_t seed)
{
  const SimulatedDrive drive(seed);
  MapOfRun standard(ClassifierKind::standard, Poses::exact, drive.vehicle());
  MapOfRun paper(ClassifierKind::paper, Poses::exact, drive.vehicle());
  MapOfRun with_ins(ClassifierKind::standard, Poses::ins, drive.vehicle());
  ReturnCounts returns(drive);
  drive.forEachScan(
      Poses::exact,
      [&](const points::Scan& scan, const Eigen::Isometry3d& T_map_base)
      {
        returns.add(scan, T_map_base);
        standard.insert(scan, T_map_base);
        paper.insert(scan, T_map_base);
      });
  drive.forEachScan(
      Poses::ins, [&](const points::Scan& scan, const Eigen::Isometry3d& T_map_base)
      { with_ins.insert(scan, T_map_base); });
  const layers::LayerSet truth = drive.truth();
  nlohmann::json result;
  const layers::LayerSet map = returns.with(standard.layerSet());
  result["counts"]["accuracy"] = countsOf(map, truth);
  result["counts"]["paper_accuracy"] = countsOf(returns.with(paper.layerSet()), truth);
  result["counts"]["ins_accuracy"] = countsOf(returns.with(with_ins.layerSet()), truth);
  result["counts"]["lazy_accuracy"] = countsOf(lazyMap(map), truth);
  return result;
}

/** The confusion of all runs together. */
void tell(
    const std::string& name,
    const std::vector<nlohmann::json>& runs,
    nlohmann::ordered_json& figures)
{
  constexpr std::array<const char*, 4> kClasses = {"flat", "small", "large", "obstacle"};
  std::array<std::array<double, 5>, 4> sum{};
  for (const nlohmann::json& one : runs)
  {
    for (size_t of = 0; of < 4; ++of)
    {
      for (size_t found = 0; found < 5; ++found)
      {
        sum[of][found] += one["counts"][name][of][found].get<double>();
      }
    }
  }
  double mean = 0;
  std::printf("%s: cells of each true class, as they were found\n", name.c_str());
  std::printf(
      "  %-9s %10s %10s %10s %10s %10s\n", "", "undefined", "flat", "small", "large", "obstacle");
  for (size_t of = 0; of < 4; ++of)
  {
    const double all = std::accumulate(sum[of].begin(), sum[of].end(), 0.0);
    const double accuracy = sum[of][of + 1] / all;
    mean += accuracy / 4;
    figures[name + "_" + kClasses[of]] = accuracy;
    std::printf("  %-9s", kClasses[of]);
    for (const double cells : sum[of])
    {
      std::printf(" %10.0f", cells);
    }
    std::printf("   %.4f\n", accuracy);
  }
  figures[name + "_mean"] = mean;
}

int runAll(const std::vector<std::string>& args)
{
  const SeedOptions options = seedOptions(args, {101, 200, ""});
  const std::vector<nlohmann::json> runs = runSeeds(options, run);
  nlohmann::ordered_json figures;
  for (const char* name : {"accuracy", "paper_accuracy", "ins_accuracy", "lazy_accuracy"})
  {
    tell(name, runs, figures);
  }
  figures["seeds"] = std::to_string(options.first) + "-" + std::to_string(options.last);
  std::cout << figures.dump() << "\n";
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  return traverse::testing::reported("paper-3", [&] { return runAll({argv + 1, argv + argc}); });
}
