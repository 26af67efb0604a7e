// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "truth_pieces.h"

#include <cstdint>
#include <vector>

namespace traverse::simulation
{
/** What stands on a place of the ground, from there upward to the first gap that the vehicle fits
 * under. */
struct Stack
{
  float hard_m = 0;                      //!< top of what does not yield
  float top_m = 0;                       //!< top of all of it
  uint32_t top_object = Scene::kGround;  //!< whose that is
  bool overhang = false;                 //!< something hangs above the gap
};

/** Builds stacks; keeps its memory from one to the next. */
class Stacker
{
 public:
  Stacker(const Pieces& pieces, float vehicle_height_m) :
      pieces_(pieces), vehicle_height_m_(vehicle_height_m)
  {
  }

  /** On the ground of this height at a sub-square. */
  Stack at(size_t sub, float ground_m);

 private:
  const Pieces& pieces_;
  float vehicle_height_m_;
  std::vector<Interval> sorted_;
};
}  // namespace traverse::simulation
