// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>
#include <traverse/simulation/truth.h>

#include <string>
#include <vector>

namespace traverse::simulation
{
/** What the truth files are made of, besides the scene. */
struct TruthRequest
{
  geometry::Vehicle vehicle;
  TruthParams params;
  double from_s = 0;  //!< moving things between these times mark the cells that they covered
  double to_s = 0;    //!< and the cells are judged with things where they are at this one
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  std::vector<poses::StampedPose> trajectory;  //!< exact poses of the vehicle
};

/** A file to write. */
struct TruthFile
{
  std::string name;
  std::string bytes;
};

/** The truth in open formats (doc/simulation.md): truth_*.tif per layer of cellTruth() and
 * sweptCells(), footprints.geojson, objects.csv, trajectory.tum. The same bytes on every machine
 * with the same GDAL. Throws as cellTruth(). */
std::vector<TruthFile> truthFiles(const Scene& scene, const TruthRequest& request);
}  // namespace traverse::simulation
