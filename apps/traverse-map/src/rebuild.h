// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"
#include "settings.h"

#include <traverse/common_app/map_set.h>

#include <vector>

namespace traverse::app
{
/** Throws config::ConfigError where a map cannot be put together piece by piece. */
void checkRebuildable(const std::vector<BuiltMap>& maps);

/** Feeds the centres of the occupied leaves of settings.rebuild to all maps, one square tile a
 * scan. A tile's pose is level, over its middle, at the height that a vehicle on the ground there
 * has (by the lowest leaves of the columns around); its stamp is 0.
 *
 * Throws formats::FormatError where the file cannot be read or is no whole octree. */
void mapOctree(const Settings& settings, std::vector<BuiltMap>& maps, RunMetrics& metrics);
}  // namespace traverse::app
