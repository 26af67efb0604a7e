// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patch_grid.h"
#include "spread.h"
#include "surfaces.h"

#include <traverse/ground/estimator.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace traverse::ground
{
namespace
{
bool isBefore(const Seed& a, const Seed& b)
{
  const auto key = [](const Seed& s)
  { return std::tie(s.radius_m, s.y_m, s.x_m, s.z_m, s.slope_x, s.slope_y); };
  return key(a) < key(b);
}
}  // namespace

int32_t cellsAlongPatch(double patch_m, const geometry::Lattice& lattice)
{
  constexpr int32_t kMost = 50;
  return std::clamp(static_cast<int32_t>(std::lround(patch_m / lattice.cell_m())), 1, kMost);
}

struct Estimator::WorkSpace
{
  PatchGrid grid;
  std::vector<Seed> seeds;
  Surfaces surfaces;
  std::vector<Verdict> verdicts;
};

Estimator::Estimator() : work_(std::make_unique<WorkSpace>()) {}

// A work space is no state: a copy begins with an empty one.
Estimator::Estimator(const Estimator& /*other*/) : Estimator() {}

Estimator::Estimator(Estimator&& other) noexcept = default;

Estimator& Estimator::operator=(Estimator other) noexcept
{
  std::swap(work_, other.work_);
  return *this;
}

Estimator::~Estimator() = default;

std::span<const Verdict> Estimator::estimate(
    std::span<const Column> columns,
    std::span<const Seed> seeds,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window,
    const Params& params)
{
  spread(columns, seeds, lattice, window, params);
  if (columns.empty() || seeds.empty() || window.empty())
  {
    work_->verdicts.assign(columns.size(), {});
    return work_->verdicts;
  }
  work_->surfaces.judge(work_->grid, params, work_->verdicts);
  return work_->verdicts;
}

void Estimator::spread(
    std::span<const Column> columns,
    std::span<const Seed> seeds,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window,
    const Params& params)
{
  if (work_ == nullptr)  // moved from
  {
    work_ = std::make_unique<WorkSpace>();
  }
  if (columns.empty() || seeds.empty() || window.empty())
  {
    work_->grid.reset({}, lattice, {}, params.patch_m);
    return;
  }
  work_->grid.reset(columns, lattice, window, params.patch_m);
  work_->seeds.assign(seeds.begin(), seeds.end());
  std::sort(work_->seeds.begin(), work_->seeds.end(), isBefore);
  Spread(work_->grid, params).from(work_->seeds);
}

PatchPlane Estimator::planeAt(geometry::CellIndex cell) const
{
  const int32_t patch = work_ == nullptr ? -1 : work_->grid.patchOf(cell);
  if (patch < 0 || !work_->grid.at(patch).isSettled())
  {
    return {};
  }
  const Patch& p = work_->grid.at(patch);
  return {p.z_m(), p.slopeX(), p.slopeY(), p.gap_m};
}
}  // namespace traverse::ground
