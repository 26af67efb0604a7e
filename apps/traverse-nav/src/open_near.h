// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>
#include <traverse/navigation/planner.h>

#include <optional>

namespace traverse::app
{
/** From far off a goal may look blocked that is not: the open place next to it (within 4 m), to
 * look from there. */
std::optional<navigation::Goal> openNear(
    const navigation::Costmap& costmap, const navigation::Goal& goal);
}  // namespace traverse::app
