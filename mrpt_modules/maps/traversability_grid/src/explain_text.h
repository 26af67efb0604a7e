// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <cstdint>
#include <string>
#include <vector>

namespace traverse::traversability_grid
{
/** "1.234 m": to the millimetre that heights are kept in. */
std::string metres(double value);

/** Four digits are enough for people; "none" for NaN. */
std::string shortly(double value);

/** "... s since 1970" with all nine decimals. */
std::string seconds(poses::TimeNs time);

/** " by A, B": the labels whose bits are set, which came with the log: what cannot be printed is
 * replaced. */
std::string sensorsOf(const std::vector<std::string>& labels, uint32_t bits);
}  // namespace traverse::traversability_grid
