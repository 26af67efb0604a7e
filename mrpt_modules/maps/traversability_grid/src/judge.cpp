// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/traversability_grid/judge.h>

#include <algorithm>
#include <cmath>

namespace traverse::traversability_grid
{
namespace
{
constexpr double kMmPerM = geometry::kMillimetresPerMetre;

/** Points scatter as noise does up to this many times its variance; from the second on by what is
 * there, and in between by both. */
constexpr double kNoiseOnly = 1.2;
constexpr double kNoNoise = 4;

/** How far noise takes the farthest point off the cell's surface, as the points' scatter has it. */
float noiseOf(const Features& f)
{
  const double beyond = f.residual_m2 - kNoiseOnly * f.noise_m2;
  const double most = (kNoNoise - kNoiseOnly) * f.noise_m2;
  const double share = beyond <= 0 ? 1 : beyond >= most ? 0 : 1 - beyond / most;
  return static_cast<float>(share * noiseSpan_m(f));
}

/** A level beam meets what stands upright, and sees nothing of its height: it is taken to be so
 * high.
 */
constexpr double kUpright_m = 0.5;

ground::Params groundParams(const Params& params, const geometry::Vehicle& vehicle)
{
  ground::Params p = params.ground;
  p.step_m = std::max(p.step_m, vehicle.max_step_m);
  p.most_slope_deg = std::max(p.most_slope_deg, vehicle.max_slope_deg);
  return p;
}

/** Cells that the ground crosses without points. */
int32_t groundReach(const Params& params, const geometry::Lattice& lattice)
{
  return static_cast<int32_t>(params.ground.most_gap_m / lattice.cell_m());
}

/** The window, and the driven cells from which ground can come into it. */
geometry::CellRect withDriven(
    const geometry::CellRect& window,
    const DrivenCells& driven,
    const geometry::Lattice& lattice,
    int32_t reach)
{
  if (driven.anyIn(window, lattice))
  {
    return window;
  }
  const geometry::CellRect wide{
      {window.min.x - reach, window.min.y - reach}, {window.max.x + reach, window.max.y + reach}};
  return geometry::bounding(window, driven.boundsIn(wide, lattice));
}

/** What a class by itself and a step against the ground make together. */
Class worse(Class a, Class b)
{
  return static_cast<Class>(std::max(static_cast<uint8_t>(a), static_cast<uint8_t>(b)));
}
}  // namespace

void Judge::begin(
    const Params& params,
    const geometry::Vehicle& vehicle,
    const geometry::Lattice& lattice,
    const geometry::CellRect& window,
    const DrivenCells& driven)
{
  params_ = params;
  classify_.emplace(params);
  ground_params_ = groundParams(params, vehicle);
  clearance_m_ = vehicle.height_m;
  lattice_ = lattice;
  columns_.clear();
  judgements_.clear();
  if (params.classifier == ClassifierKind::paper)
  {
    return;
  }
  window_ = withDriven(window, driven, lattice, groundReach(params, lattice));
  reference_mm_ = driven.referenceIn(window_, lattice);
  driven.seedsIn(window_, lattice, reference_mm_, seeds_);
}

void Judge::add(geometry::CellIndex cell, const Features& f)
{
  judgements_.push_back(byItself(f));
  if (params_.classifier != ClassifierKind::paper)
  {
    columns_.push_back(columnOf(cell, f));
  }
}

Judgement Judge::byItself(const Features& f) const
{
  Judgement judgement;
  judgement.of = (*classify_)(f);
  judgement.top_mm = static_cast<float>(f.max_m * kMmPerM);
  return judgement;
}

ground::Column Judge::columnOf(geometry::CellIndex cell, const Features& f) const
{
  const double reference_m = static_cast<double>(reference_mm_) / kMmPerM;
  const auto above = [&](double height_m) { return static_cast<float>(height_m - reference_m); };
  constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();
  return {
      cell,
      static_cast<uint32_t>(std::min(f.n, kMost)),
      above(f.min_m),
      above(f.mean_m),
      above(2 * f.level_n > f.n ? std::max(f.max_m, f.min_m + kUpright_m) : f.max_m),
      above(f.max_m),
      noiseOf(f)};
}

void Judge::finish(const Reread& reread)
{
  if (params_.classifier == ClassifierKind::paper)
  {
    return;
  }
  const std::span<const ground::Verdict> verdicts =
      estimator_.estimate(columns_, seeds_, lattice_, window_, ground_params_);
  for (size_t i = 0; i < judgements_.size(); ++i)
  {
    if (verdicts[i].isKnown())
    {
      const bool is_false = columns_[i].low_m < verdicts[i].ground_m - kFalseReturn_m;
      const ground::Verdict verdict = is_false ? secondLook(i, verdicts[i], reread) : verdicts[i];
      if (verdict.isKnown())
      {
        againstGround(columns_[i], verdict, judgements_[i]);
      }
    }
  }
}

ground::Verdict Judge::secondLook(size_t i, const ground::Verdict& first, const Reread& reread)
{
  const double floor_m = (first.ground_m - kFloor_m);
  const Features f = reread(i, reference_mm_ + static_cast<int64_t>(std::floor(floor_m * kMmPerM)));
  const ground::Column column = columnOf(columns_[i].cell, f);
  if (!(column.low_m > columns_[i].low_m))
  {
    // Nothing above: a hole in ground that was measured, else ground that the estimate does not
    // know, which says nothing of the cell.
    Class& of = judgements_[i].of;
    of = first.is_measured && of != Class::undefined ? Class::obstacle : of;
    return {};
  }
  columns_[i] = column;
  judgements_[i] = byItself(f);
  ground::Verdict verdict;
  verdict.ground_m = first.ground_m;
  if (column.low_m - first.ground_m <= static_cast<float>(ground_params_.over_patch_m))
  {
    verdict.limit_m = first.ground_m + static_cast<float>(ground_params_.over_surface_m);
  }
  return verdict;
}

Class Judge::withRelief(Class of, const ground::Verdict& verdict) const
{
  if (of == Class::undefined)
  {
    return of;
  }
  const Class all = worse(of, classify_->ofStep(verdict.relief_m));
  return verdict.is_low_growth ? std::min(all, Class::large_roughness) : all;
}

void Judge::againstGround(
    const ground::Column& column, const ground::Verdict& verdict, Judgement& judgement) const
{
  const auto reference_mm = static_cast<double>(reference_mm_);
  judgement.ground_m = static_cast<float>(reference_mm / kMmPerM + verdict.ground_m);
  if (verdict.bearsGround())
  {
    judgement.ground_limit_mm = static_cast<float>(reference_mm + verdict.limit_m * kMmPerM);
    judgement.of = withRelief(judgement.of, verdict);
    return;
  }
  const double rise_m = column.low_m - verdict.ground_m;
  judgement.overhangs = params_.ignore_overhangs && rise_m >= clearance_m_;
  if (judgement.overhangs)
  {
    judgement.of = Class::undefined;  // nothing was seen of what the vehicle would drive on
  }
  else if (judgement.of != Class::undefined)
  {
    judgement.of = worse(judgement.of, classify_->ofStep(rise_m));
  }
}
}  // namespace traverse::traversability_grid
