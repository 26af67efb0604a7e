// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_grid.h"

#include <traverse/ground/params.h>

#include <span>
#include <vector>

namespace traverse::ground
{
/** What a column is, seen from the settled patches. */
struct Surface
{
  float over_m = 0;   //!< its mean height over the patches
  float tilt_m = 0;   //!< what the ground's slope adds to a cell's span
  bool flat = false;  //!< all of it is ground
};

/** Judges every column against the patches and the flat columns around it. */
class Surfaces
{
 public:
  Surfaces(const PatchGrid& grid, std::span<const Column> columns, const Params& params);

  void judge(std::vector<Surface>& surfaces, std::vector<Verdict>& verdicts) const;

 private:
  float groundAt(geometry::CellIndex cell) const;
  Surface firstLook(const Column& column, float ground_m) const;
  bool isSupported(const Column& column, std::span<const Surface> surfaces, size_t i) const;
  float limitOfRough(const Column& column, float ground_m, std::span<const Surface> surfaces) const;

  const PatchGrid& grid_;
  std::span<const Column> columns_;
  const Params& params_;
};
}  // namespace traverse::ground
