// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scores.h"

#include <string>

namespace traverse::app
{
/** The scores as JSON text; what cannot be told is null. */
std::string scoresJson(const Scores& scores);

/** The median of values; NaN of none. */
double medianOf(std::vector<double> values);
}  // namespace traverse::app
