// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"
#include "settings.h"

#include <traverse/common_app/map_set.h>
#include <traverse/points/decoded.h>
#include <traverse/poses/pose_track.h>

#include <atomic>
#include <functional>

namespace traverse::app
{
/** Begins the metrics of these maps, in their order. */
void listMaps(const std::vector<BuiltMap>& maps, RunMetrics& metrics);

/** Inserts a scan and adds up what became of it. */
void insert(
    const points::Scan& scan, const poses::PoseTrack& track, BuiltMap& map, MapMetrics& metrics);

/** Called after each scan with what it was, deskewed; for labels and snapshots. */
using AfterScan = std::function<void(const points::Decoded&)>;

/** Feeds every scan of the log, decoded once and deskewed, to all maps. Damage of the log ends the
 * loop and is told in `metrics`; what came before it is in the maps. */
void mapLog(
    const Settings& settings,
    const poses::PoseTrack& track,
    std::vector<BuiltMap>& maps,
    RunMetrics& metrics,
    const AfterScan& after_scan);
}  // namespace traverse::app
