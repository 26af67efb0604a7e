// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "exports.h"

#include <traverse/formats/cloud_export.h>
#include <traverse/formats/geopackage.h>

namespace traverse::app
{
Path_m trajectoryOf(const poses::PoseTrack& track)
{
  Path_m path;
  if (track.moves())
  {
    path.reserve(track.poses().size());
    for (const poses::StampedPose& pose : track.poses())
    {
      const Eigen::Vector3d p = pose.T_map_base.translation();
      path.push_back({p.x(), p.y(), p.z()});
    }
  }
  return path;
}

void writeExports(
    const RunParams& run,
    const std::string& suffix,
    const MapLayers& map,
    const std::function<void(const std::string& name, const std::string& bytes)>& write)
{
  const std::string stem = "map" + suffix;
  if (run.export_ply)
  {
    write(stem + ".ply", formats::plyCloud(map.layers));
  }
  if (run.export_pcd)
  {
    write(stem + ".pcd", formats::pcdCloud(map.layers));
  }
  if (run.export_geopackage)
  {
    write(stem + ".gpkg", formats::geoPackage(map.layers, map.trajectory_m));
  }
}
}  // namespace traverse::app
