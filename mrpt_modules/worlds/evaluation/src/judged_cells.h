// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/cells.h>
#include <traverse/evaluation/confusion.h>

#include <algorithm>
#include <limits>

namespace traverse::evaluation
{
/** NaN of nothing. */
inline double share(uint64_t part, uint64_t whole)
{
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

/** A map's classes beside the true ones, and which cells are judged. */
class JudgedCells
{
 public:
  JudgedCells(
      const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params) :
      found_(viewOf<uint8_t>(map, map.class_layer)),
      truth_(viewOf<uint8_t>(truth, params.truth_layer)),
      min_returns_(params.min_returns)
  {
    checkLattice(map, truth);
    const layers::Layer* returns = map.find(params.returns_layer);
    if (returns != nullptr && std::holds_alternative<std::vector<uint8_t>>(returns->data))
    {
      few_returns_ = viewOf<uint8_t>(map, params.returns_layer);
    }
    else
    {
      returns_ = viewOf<uint32_t>(map, params.returns_layer);
    }
    if (truth.find(params.left_out_layer) != nullptr)
    {
      left_out_ = viewOf<uint8_t>(truth, params.left_out_layer);
    }
  }

  bool judged(geometry::CellIndex c) const
  {
    return truth_.at(c) != 0 && !leftOut(c) &&
           std::max<uint32_t>(few_returns_.at(c), returns_.at(c)) >= min_returns_;
  }

  bool leftOut(geometry::CellIndex c) const { return left_out_.at(c) != 0; }

  uint8_t found(geometry::CellIndex c) const { return found_.at(c); }

  uint8_t truth(geometry::CellIndex c) const { return truth_.at(c); }

  const CellView<uint8_t>& truth() const { return truth_; }

 private:
  CellView<uint8_t> found_;
  CellView<uint8_t> truth_;
  CellView<uint8_t> few_returns_;  // one of the two is empty
  CellView<uint32_t> returns_;
  CellView<uint8_t> left_out_;
  uint32_t min_returns_;
};
}  // namespace traverse::evaluation
