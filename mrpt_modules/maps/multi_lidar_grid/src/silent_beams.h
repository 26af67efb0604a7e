// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_fans.h"
#include "rules.h"

#include <traverse/multi_lidar_grid/cloud.h>

namespace traverse::multi_lidar_grid
{
/** Adds the beams that met nothing to the fans, of a sensor whose every beam comes back from
 * whatever is near. */
void addSilentBeams(
    const Cloud& cloud, const SensorParams& sensor, const Rules& rules, BeamFans& fans);
}  // namespace traverse::multi_lidar_grid
