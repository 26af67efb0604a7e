// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/ground/column.h>
#include <traverse/ground/params.h>

#include <memory>
#include <span>
#include <vector>

namespace traverse::ground
{
/** Cells along a patch's edge: 1 to 50, so that patches of small cells are smaller. */
int32_t cellsAlongPatch(double patch_m, const geometry::Lattice& lattice);

/** The ground estimate that all maps share.
 *
 * It spreads from seeds, where the vehicle stands or drove, from patch to patch outward: each patch
 * (1 m) is predicted from the settled ones around it, and takes that surface of its columns for
 * ground that lies within a step and a change of slope of the prediction; walls, roofs and whatever
 * else does not is passed by, the prediction going on. Then every column is judged against the
 * patches and the flat columns around it.
 *
 * The result depends on the sets of columns and seeds only, not on their order, and has the same
 * bits on every processor. Costs by columns and by the patches of the window. Spreading a ground
 * from patch to patch is known from GroundGrid (Steinke et al. 2023) and TRAVEL (Oh et al. 2022);
 * the rules are our own. */
class Estimator
{
 public:
  Estimator();
  Estimator(const Estimator& other);
  Estimator(Estimator&& other) noexcept;
  Estimator& operator=(Estimator other) noexcept;
  ~Estimator();

  /** One verdict per column, valid until the next call. Columns lie in `window` and have different
   * cells; those that no spreading reached stay unknown. Throws std::length_error for windows of
   * more than kMostPatches. */
  std::span<const Verdict> estimate(
      std::span<const Column> columns,
      std::span<const Seed> seeds,
      const geometry::Lattice& lattice,
      const geometry::CellRect& window,
      const Params& params);

  /** The patches alone, at half the cost: no column is judged. */
  void spread(
      std::span<const Column> columns,
      std::span<const Seed> seeds,
      const geometry::Lattice& lattice,
      const geometry::CellRect& window,
      const Params& params);

  /** What the last estimate() or spread() left in the patch of a cell. */
  PatchPlane planeAt(geometry::CellIndex cell) const;

  static constexpr int64_t kMostPatches = 100'000'000;

 private:
  struct WorkSpace;
  std::unique_ptr<WorkSpace> work_;
};
}  // namespace traverse::ground
