// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
};

/** A file to write. */
struct TruthFile
{
  std::string name;
  std::string bytes;
};

/** The truth about places in open formats (doc/simulation.md): truth_*.tif per layer of cellTruth()
 * and sweptCells(), footprints.geojson. (What belongs to a recording, objects.csv, labels of points
 * and trajectory.tum, is the app's.) The same bytes on every machine
 * with the same GDAL. Throws as cellTruth(). */
std::vector<TruthFile> truthFiles(const Scene& scene, const TruthRequest& request);

/** From one place of a moving thing in movingThings() to its next, s. */
inline constexpr double kMovingStepSeconds = 0.1;

/** moving.geojson: where the things that have a track stand from the beginning to to_s (standing
 * still, too), as footprints.geojson with a property `time_s`, s since 1970 of the recording's
 * clock. Throws as footprints(). */
TruthFile movingThings(const Scene& scene, const geometry::Vehicle& vehicle, double to_s);
}  // namespace traverse::simulation
