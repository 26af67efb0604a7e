// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/maps/CTraversabilityGridMap.h>
#include <traverse/plugin/register.h>

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/maps/CMultiMetricMap.h>

#include <iostream>

int main()
{
  traverse::plugin::registerAllMaps();
  mrpt::config::CConfigFileMemory file(
      "[map]\nCTraversabilityGridMap_count = 1\n"
      "[map_CTraversabilityGridMap_00_insertOpts]\nextent = growing\n");
  mrpt::maps::TSetOfMetricMapInitializers definitions;
  definitions.loadFromConfigFile(file, "map");
  mrpt::maps::CMultiMetricMap maps;
  maps.setListOfMaps(definitions);
  const auto grid = maps.mapByClass<traverse::maps::CTraversabilityGridMap>();
  if (!grid)
  {
    std::cerr << "the factory made no map\n";
    return 1;
  }

  traverse::points::ScanBuffer scan;
  for (int i = 0; i < 9; ++i)
  {
    scan.x.push_back(1.0F + 0.05F * static_cast<float>(i % 3));
    scan.y.push_back(1.0F + 0.05F * static_cast<float>(i / 3));
    scan.z.push_back(0);
  }
  auto* consumer = dynamic_cast<traverse::layers::ScanConsumer*>(grid.get());
  const auto here = traverse::poses::PoseTrack::constant(Eigen::Isometry3d::Identity());
  const auto stats = consumer->insertScan(scan.view(), here);
  const auto set = consumer->layerSet();
  std::cout << stats.points << " points in " << set.size() << " cell\n" << grid->asString() << "\n";
  return stats.points == 9 && set.size() == 1 ? 0 : 1;
}
