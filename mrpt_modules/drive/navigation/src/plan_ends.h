// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/price_field.h>

#include <vector>

// Where ways may end that do not end at their goal.
namespace traverse::navigation
{
/** Where the known ends: at the border, and at unknown cells that are not planned through; with
 * what the straight line from there to a place costs. */
std::vector<PriceField::Seed> endsOfTheKnown(
    const Costmap& costmap, const Terrain& terrain, Place to);

/** Open places; a metre further from `to` costs `nearness` metres of the mean price. */
std::vector<PriceField::Seed> placesNear(
    const Costmap& costmap, const Terrain& terrain, Place to, double nearness);
}  // namespace traverse::navigation
