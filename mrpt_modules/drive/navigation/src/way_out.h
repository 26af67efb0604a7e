// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/costmap.h>
#include <traverse/navigation/path.h>

namespace traverse::navigation
{
/** How much of a path's beginning leads out of hard and obstacle cells, m: to where its last leg
 * that touches one ends. */
double wayOut_m(const Costmap& costmap, const Path& path);
}  // namespace traverse::navigation
