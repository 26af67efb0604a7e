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
  Spread(PatchGrid& grid, const Params& params);

  void from(std::span<const Seed> seeds);

 private:
  static constexpr size_t kNearest = 8;
  static constexpr size_t kAround = 24;

  /** A neighbour of a patch. */
  struct Neighbour
  {
    Quad x_m = {};  //!< its place, in the first of the four; 0 in the others
    Quad y_m = {};
    Quad squares = {};   //!< x^2, x y, y^2
    int32_t offset = 0;  //!< in the patches' array
    float distance_m = 0;
    float weight = 0;
  };

  /** What the settled patches around say of a patch. */
  struct Prediction
  {
    Quad plane = {};  //!< as Patch::plane, without a weight
    float gap_m = 0;

    float z_m() const { return plane[0]; }

    float slopeX() const { return plane[1]; }

    float slopeY() const { return plane[2]; }
  };

  struct Candidate
  {
    float z_m = 0;
    uint32_t n = 0;
  };

  Neighbour neighbour(int32_t x, int32_t y) const;
  void plant(const Seed& seed);
  void pushAround(int32_t patch);
  void push(int32_t patch);
  template <size_t count>
  Prediction predict(int32_t i) const;
  void settle(int32_t i, const Prediction& predicted);
  void settleColumns(int32_t i, const Prediction& predicted);
  void put(int32_t i, Quad plane, float gap_m);
  void findCandidates(const Patch& patch, const Prediction& predicted);
  size_t overTrench(size_t lowest, const Prediction& predicted) const;
  float lowestSurface(const Prediction& predicted);
  Quad fitSlope(int32_t i, float z_m, const Prediction& predicted) const;

  PatchGrid& grid_;
  const Params& params_;
  float most_slope_;
  std::array<Neighbour, kAround> around_;  //!< the eight nearest first
  std::vector<int32_t> queue_;
  std::vector<Candidate> candidates_;
};
}  // namespace traverse::ground
