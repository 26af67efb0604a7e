// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/velodyne_scan.h>
#include <traverse/simulation/lidar.h>

namespace traverse::simulation
{
/** What a decoder without limits of range makes of a simulated turn: the points of
 * LidarTurn::returns, in their order. */
points::Decoded decodeTurn(const LidarTurn& turn);
}  // namespace traverse::simulation
