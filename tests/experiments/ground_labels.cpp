// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ground against everything else on real labelled clouds, each by itself, for points at 3 to 60 m:
// classifier = default and paper with their defaults. Mount heights and the turn of nuScenes'
// sensor frame are data. Peers on the same clouds: doc/benchmarks.md.
//
//   ground-labels [--data DIR --layout kitti|nuscenes]
#include <cstdio>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <support/data.h>
#include <support/experiment.h>
#include <support/ground_score.h>

namespace
{
using namespace traverse;
using namespace traverse::testing;

void tell(const std::string& prefix, const GroundScore& score, nlohmann::ordered_json& figures)
{
  figures[prefix + "_f1"] = score.f1();
  figures[prefix + "_precision"] = score.precision();
  figures[prefix + "_recall"] = score.recall();
}

void measure(Layout layout, const std::filesystem::path& folder, nlohmann::ordered_json& figures)
{
  using traversability_grid::ClassifierKind;
  const std::string name = layout == Layout::kitti ? "kitti" : "nuscenes";
  std::map<ClassifierKind, GroundScore> scores;
  const auto files = labelledFiles(layout, folder);
  for (const auto& [points, labels] : files)
  {
    const LabelledCloud cloud = readLabelled(layout, points, labels);
    for (const ClassifierKind kind : {ClassifierKind::standard, ClassifierKind::paper})
    {
      scores[kind].add(cloud, layout, labelsOf(cloud, kind, mountHeight_m(layout)));
    }
  }
  tell("default_" + name, scores[ClassifierKind::standard], figures);
  tell("paper_" + name, scores[ClassifierKind::paper], figures);
  figures[name + "_clouds"] = files.size();
}

int usage()
{
  std::cerr << "usage: ground-labels [--data DIR --layout kitti|nuscenes]\n";
  return 2;
}

int run(const std::vector<std::string>& args)
{
  nlohmann::ordered_json figures;
  if (args.empty())
  {
    measure(Layout::kitti, sharedData("kitti-odo00-labelled"), figures);
    measure(Layout::nuscenes, sharedData("nuscenes-hdl32-labelled"), figures);
  }
  else if (
      args.size() == 4 && args[0] == "--data" && args[2] == "--layout" &&
      (args[3] == "kitti" || args[3] == "nuscenes"))
  {
    measure(args[3] == "kitti" ? Layout::kitti : Layout::nuscenes, args[1], figures);
  }
  else
  {
    return usage();
  }
  std::cout << figures.dump() << "\n";
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  return traverse::testing::reported("ground-labels", [&] { return run({argv + 1, argv + argc}); });
}
