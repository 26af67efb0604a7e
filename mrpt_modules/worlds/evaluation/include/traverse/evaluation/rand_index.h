// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>

namespace traverse::evaluation
{
/** Adjusted Rand index of two labelings of the same things (Hubert and Arabie, 1985): 1 where they
 * are the same up to names, about 0 by chance, below 0 worse than chance. 1 where both put all into
 * one group, or each thing into one of its own; NaN for fewer than two things. Throws
 * std::invalid_argument for labelings of different length. */
double adjustedRandIndex(std::span<const uint32_t> a, std::span<const uint32_t> b);
}  // namespace traverse::evaluation
