// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patch_grid.h"

#include <traverse/ground/params.h>

#include <array>
#include <span>
#include <vector>

namespace traverse::ground
{
/** Settles patch after patch, outward from the seeds. */
class Spread
{
 public:
  Spread(PatchGrid& grid, std::span<const Column> columns, const Params& params);

  void from(std::span<const Seed> seeds);

 private:
  /** A neighbour of a patch. */
  struct Neighbour
  {
    int32_t offset = 0;  //!< in the patches' array
    float x_m = 0;
    float y_m = 0;
    float distance_m = 0;
    float weight = 0;
  };

  /** What the settled patches around say of a patch. */
  struct Prediction
  {
    float z_m = 0;
    float slope_x = 0;
    float slope_y = 0;
    float gap_m = 0;
  };

  struct Candidate
  {
    float z_m = 0;
    uint32_t n = 0;
  };

  void plant(const Seed& seed);
  void pushAround(int32_t patch);
  void settle(int32_t i, const Prediction& predicted);
  Prediction predict(int32_t i) const;
  void findCandidates(const Patch& patch, const Prediction& predicted);
  float lowestSurface();
  void fitSlope(int32_t i, const Prediction& predicted);

  PatchGrid& grid_;
  std::span<const Column> columns_;
  const Params& params_;
  float most_slope_;
  std::array<Neighbour, 24> around_;  //!< the eight nearest first
  std::vector<int32_t> queue_;
  std::vector<Candidate> candidates_;
};
}  // namespace traverse::ground
