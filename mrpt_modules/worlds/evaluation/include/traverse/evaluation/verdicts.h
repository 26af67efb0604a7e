// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/confusion.h>
#include <traverse/layers/layer_set.h>

#include <cstdint>

namespace traverse::evaluation
{
/** What is right or wrong with a cell; the codes of the layer "verdict". */
enum class Verdict : uint8_t
{
  not_judged = 0,  //!< too few returns, no truth, left out
  right = 1,
  missed_obstacle = 2,  //!< a true obstacle that is none in the map
  false_obstacle = 3,   //!< the other way round
  too_easy = 4,         //!< neither is an obstacle, and the map's class is the easier one
  too_rough = 5,        //!< the other way round
  undefined = 6,        //!< the map says nothing although it has returns enough
};

/** Layer "verdict" over the truth's cells, for pictures of where a map is wrong. Throws
 * std::invalid_argument as confusionOf(). */
layers::LayerSet verdicts(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params = {});
}  // namespace traverse::evaluation
