// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/decoded.h>

#include <Eigen/Geometry>

namespace traverse::points
{
/** Takes the points within a box of the vehicle frame (the vehicle's own body) out of the scan,
 * counted as excluded; their beams become rejected. */
void excludeBox(Decoded& decoded, const Eigen::AlignedBox3f& box);
}  // namespace traverse::points
