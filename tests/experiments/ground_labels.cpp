// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ground against everything else on real labelled clouds, each by itself, for points at 3 to 60 m:
// classifier = default and paper with their defaults. Mount heights and the turn of nuScenes'
// sensor frame are data. Peers on the same clouds: doc/benchmarks.md.
//
//   ground-labels [--data DIR --layout kitti|nuscenes]
#include <traverse/traversability_grid/point_labels.h>
#include <traverse/traversability_grid/traversability_grid.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <support/data.h>
#include <support/labelled_clouds.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using traversability_grid::PointLabel;

constexpr double kNearest_m = 3;
constexpr double kFarthest_m = 60;

struct Score
{
  double found = 0;   // ground, called ground
  double missed = 0;  // ground, called something else
  double wrong = 0;   // called ground, and is none

  void add(bool is_ground, bool called_ground)
  {
    found += is_ground && called_ground ? 1 : 0;
    missed += is_ground && !called_ground ? 1 : 0;
    wrong += !is_ground && called_ground ? 1 : 0;
  }

  void tell(const std::string& prefix, nlohmann::ordered_json& figures) const
  {
    figures[prefix + "_f1"] = 2 * found / (2 * found + missed + wrong);
    figures[prefix + "_precision"] = found / (found + wrong);
    figures[prefix + "_recall"] = found / (found + missed);
  }
};

std::vector<PointLabel> labelsOf(
    const LabelledCloud& cloud, Layout layout, traversability_grid::ClassifierKind classifier)
{
  traversability_grid::Params params;
  params.classifier = classifier;
  params.mode = traversability_grid::Mode::single_cloud;
  geometry::Vehicle vehicle;
  vehicle.base_height_m = mountHeight_m(layout);
  traversability_grid::State state = traversability_grid::makeState(params, vehicle);
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  traversability_grid::update(state, cloud.scan.view(), here, params, vehicle);
  return traversability_grid::labelsOfLastScan(state, cloud.scan.view(), here, params);
}

void score(
    Score& score, const LabelledCloud& cloud, Layout layout, const std::vector<PointLabel>& labels)
{
  for (size_t i = 0; i < labels.size(); ++i)
  {
    const float x = cloud.scan.x[i];
    const float y = cloud.scan.y[i];
    const float z = cloud.scan.z[i];
    const double range = std::sqrt(x * x + y * y + z * z);
    const std::optional<bool> truth = isGround(layout, cloud.labels[i]);
    if (truth && range >= kNearest_m && range <= kFarthest_m)
    {
      score.add(*truth, labels[i] == PointLabel::ground);
    }
  }
}

void measure(Layout layout, const std::filesystem::path& folder, nlohmann::ordered_json& figures)
{
  using traversability_grid::ClassifierKind;
  const std::string name = layout == Layout::kitti ? "kitti" : "nuscenes";
  std::map<ClassifierKind, Score> scores;
  const auto files = labelledFiles(layout, folder);
  for (const auto& [points, labels] : files)
  {
    const LabelledCloud cloud = readLabelled(layout, points, labels);
    for (const ClassifierKind kind : {ClassifierKind::standard, ClassifierKind::paper})
    {
      score(scores[kind], cloud, layout, labelsOf(cloud, layout, kind));
    }
  }
  scores[ClassifierKind::standard].tell("default_" + name, figures);
  scores[ClassifierKind::paper].tell("paper_" + name, figures);
  figures[name + "_clouds"] = files.size();
}

int usage()
{
  std::cerr << "usage: ground-labels [--data DIR --layout kitti|nuscenes]\n";
  return 2;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> args(argv + 1, argv + argc);
  nlohmann::ordered_json figures;
  try
  {
    if (args.empty())
    {
      measure(Layout::kitti, sharedData("kitti-odo00-labelled"), figures);
      measure(Layout::nuscenes, sharedData("nuscenes-hdl32-labelled"), figures);
    }
    else if (args.size() == 4 && args[0] == "--data" && args[2] == "--layout")
    {
      if (args[3] != "kitti" && args[3] != "nuscenes")
      {
        return usage();
      }
      measure(args[3] == "kitti" ? Layout::kitti : Layout::nuscenes, args[1], figures);
    }
    else
    {
      return usage();
    }
  }
  catch (const std::exception& e)
  {
    std::cerr << "ground-labels: " << e.what() << "\n";
    return 4;
  }
  std::cout << figures.dump() << "\n";
}
