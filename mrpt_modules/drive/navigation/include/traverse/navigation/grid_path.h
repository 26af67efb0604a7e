// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/path.h>
#include <traverse/navigation/price_field.h>

#include <optional>
#include <span>
#include <vector>

namespace traverse::navigation
{
/** From a cell whose price the field knows down to the seed: middles of cells. */
std::vector<Place> downTheField(const PriceField& field, const Terrain& terrain, size_t from);

/** Leaves out places wherever the straight line costs no more than the way through them. */
std::vector<Place> shortened(const Terrain& terrain, std::span<const Place> places);

/** Places every step_m or less on the same way. */
std::vector<Place> resampled(std::span<const Place> places, double step_m);

/** Pulls every place towards the middle of its neighbours, again and again, as far as the way gets
 * no dearer: bends get round, and the way taut. The ends stay. */
void smooth(const Terrain& terrain, std::vector<Place>& places);

/** Sum of Terrain::priceOfLine(). */
double priceOf(const Terrain& terrain, std::span<const Place> places);

/** Drives forward through all places; the last point looks to last_yaw_rad, if that is given. */
Path pathThrough(std::span<const Place> places, std::optional<double> last_yaw_rad);
}  // namespace traverse::navigation
