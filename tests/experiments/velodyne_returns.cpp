// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// How many of the valid returns in real packets become points: our decoder beside MRPT's own.

#include <traverse/observations/to_scan.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/serialization/CArchive.h>

#include <iostream>
#include <nlohmann/json.hpp>

namespace
{
using mrpt::obs::CObservationVelodyneScan;

/** Returns with a distance: what the sensor measured. */
uint64_t validReturns(const CObservationVelodyneScan& scan)
{
  uint64_t n = 0;
  for (const auto& packet : scan.scan_packets)
  {
    for (const auto& block : packet.blocks)
    {
      for (const auto& laser : block.laser_returns)
      {
        n += static_cast<uint64_t>(laser.distance() != 0);
      }
    }
  }
  return n;
}
}  // namespace

int main()
{
  mrpt::io::CFileGZInputStream file("/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog");
  const auto scan = std::dynamic_pointer_cast<CObservationVelodyneScan>(
      mrpt::serialization::archiveFrom(file).ReadObject());
  const auto valid = static_cast<double>(validReturns(*scan));
  const auto ours = traverse::observations::toScan(*scan, {});
  scan->generatePointCloud();
  const nlohmann::ordered_json figures = {
      {"valid_returns", valid},
      {"traverse_share", static_cast<double>(ours.decoded.scan.size()) / valid},
      {"mrpt_share", static_cast<double>(scan->point_cloud.x.size()) / valid}};
  std::cout << figures.dump() << "\n";
}
