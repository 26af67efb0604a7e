// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_grid.h"
#include "relief.h"

#include <traverse/ground/params.h>

#include <span>
#include <vector>

namespace traverse::ground
{
/** Judges every column against the patches and the flat columns around it. Keeps its work space. */
class Surfaces
{
 public:
  /** Verdicts by the columns' numbers. */
  void judge(const PatchGrid& grid, const Params& params, std::vector<Verdict>& verdicts);

 private:
  /** A column that needs the flat ones around it. */
  struct Rough
  {
    int32_t patch = 0;
    uint32_t column = 0;  //!< in PatchGrid::columns()
  };

  std::vector<float> flat_mean_m_;  //!< by column of the grid; Verdict::kNone where not flat
  std::vector<Rough> rough_;
  Relief relief_;
};
}  // namespace traverse::ground
