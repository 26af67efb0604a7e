// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_params.h"

#include <traverse/layers/layer_set.h>
#include <traverse/poses/pose_track.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace traverse::app
{
using Path_m = std::vector<std::array<double, 3>>;

/** Where the vehicle was, m; nothing where it has one pose for all times. */
Path_m trajectoryOf(const poses::PoseTrack& track);

/** A map for those outside: files, report. */
struct MapLayers
{
  const layers::LayerSet& layers;
  const Path_m& trajectory_m;
};

/** Gives `write` the files that the ini asked for: map<suffix>.ply, .pcd, .gpkg. */
void writeExports(
    const RunParams& run,
    const std::string& suffix,
    const MapLayers& map,
    const std::function<void(const std::string& name, const std::string& bytes)>& write);
}  // namespace traverse::app
