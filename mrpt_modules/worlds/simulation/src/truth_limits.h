// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/simulation/truth.h>

namespace traverse::simulation
{
/** Edge of a cell in mm; throws options::OptionError for values out of range or order. */
int32_t checkedCell_mm(const TruthParams& params);
}  // namespace traverse::simulation
