// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/geometry/lattice.h>
#include <traverse/traversability_grid/features.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace traverse::traversability_grid
{
namespace
{
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kMmPerM = geometry::kMillimetresPerMetre;
constexpr double kNoisePerM2 = 1e8;  // HeightSlab::noise is in (0.1 mm)^2

/** Below this share of the horizontal scatter's square its determinant is that of a line: points a
 * millimetre off a line across a cell of 0.2 m have 1e-5. */
constexpr double kSingular = 1e-9;

/** Sums of a cell's counting slabs, millimetres, heights relative to the lowest slab's bottom. They
 * are whole numbers, exact in a double to 2^53: in 0.2 m cells for 10^8 points 20 m high. */
struct Sums
{
  double n = 0;
  double x = 0, y = 0, z = 0;
  double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  double noise = 0;

  void add(const layers::HeightSlab& s, double lift_mm)
  {
    const double m = s.n;
    const auto sx = static_cast<double>(s.x);
    const auto sy = static_cast<double>(s.y);
    const auto sz = static_cast<double>(s.z);
    n += m;
    x += sx;
    y += sy;
    z += sz + m * lift_mm;
    xx += static_cast<double>(s.xx);
    xy += static_cast<double>(s.xy);
    yy += static_cast<double>(s.yy);
    xz += static_cast<double>(s.xz) + sx * lift_mm;
    yz += static_cast<double>(s.yz) + sy * lift_mm;
    zz += static_cast<double>(s.zz) + 2 * lift_mm * sz + m * lift_mm * lift_mm;
    noise += static_cast<double>(s.noise);
  }
};

/** Normal equations of (3) about the centre, times n: whole numbers too. */
void fitPlane(const Sums& s, double base_mm, double thin_mm, Features& f)
{
  const double cxx = s.n * s.xx - s.x * s.x;
  const double cxy = s.n * s.xy - s.x * s.y;
  const double cyy = s.n * s.yy - s.y * s.y;
  const double cxz = s.n * s.xz - s.x * s.z;
  const double cyz = s.n * s.yz - s.y * s.z;
  const double determinant = cxx * cyy - cxy * cxy;
  const double scatter = cxx + cyy;
  const double thin = s.n * s.n * thin_mm * thin_mm;
  // The smaller eigenvalue is below `thin`: one of both, and the product of what they exceed it by.
  const bool is_thin =
      thin > 0 && (scatter <= 2 * thin || (cxx - thin) * (cyy - thin) <= cxy * cxy);
  f.has_plane = is_thin ? scatter > thin : determinant > kSingular * scatter * scatter;
  if (is_thin && f.has_plane)
  {
    const double half = (cxx - cyy) / 2;
    const double largest = scatter / 2 + std::sqrt(half * half + cxy * cxy);
    // The direction of the larger eigenvalue, from the row of the matrix that is not near zero.
    const double ux = cxx >= cyy ? largest - cyy : cxy;
    const double uy = cxx >= cyy ? cxy : largest - cxx;
    const double along = (ux * cxz + uy * cyz) / (largest * (ux * ux + uy * uy));
    f.slope_x = along * ux;
    f.slope_y = along * uy;
  }
  else if (f.has_plane)
  {
    f.slope_x = (cxz * cyy - cyz * cxy) / determinant;
    f.slope_y = (cyz * cxx - cxz * cxy) / determinant;
  }
  if (f.has_plane)
  {
    const double squares = s.n * s.zz - s.z * s.z - f.slope_x * cxz - f.slope_y * cyz;
    f.residual_m2 = std::max(0.0, squares) / (s.n * s.n) / (kMmPerM * kMmPerM);
    f.at_corner_m = (base_mm + (s.z - f.slope_x * s.x - f.slope_y * s.y) / s.n) / kMmPerM;
  }
}

/** The limit's square of the tangent, with room for its rounding: points on a slope of exactly 45
 * degrees do not exceed a limit of 45 degrees. */
double tan2(double degrees)
{
  constexpr double kRoom = 1 + 1e-12;
  const double tangent = geometry::tangentOf(degrees / kDegrees);  // as on every processor
  return degrees >= 90 ? std::numeric_limits<double>::infinity() : kRoom * tangent * tangent;
}

/** How far the farthest of n points lies from their mean by noise alone, in standard deviations:
 * what the largest of n normal deviates is on average, 1.2 to 4 for 3 to 8192 (to 0.25, by trial;
 * no logarithm, whose last bit differs between processors). */
double noiseSpan(uint64_t n)
{
  return std::sqrt(1.2 * static_cast<double>(std::bit_width(n) - 1));
}

/** The first slab that counts: the lowest, or, where a higher one reaches above the floor, that. */
const layers::HeightSlab* fromFloor(
    const layers::HeightSlabs& slabs, const layers::HeightSlab* lowest, const SlabReading& reading)
{
  for (const auto* s = lowest; s != nullptr; s = slabs.get(s->next))
  {
    if (int64_t{s->level} * reading.slab_mm + s->max_z_mm >= reading.floor_mm)
    {
      return s;
    }
  }
  return lowest;
}
}  // namespace

double Features::slope_deg() const
{
  return has_plane ? std::atan(std::sqrt(tan2Slope())) * kDegrees
                   : std::numeric_limits<double>::quiet_NaN();
}

double noiseSpan_m(const Features& features)
{
  return noiseSpan(features.n) * std::sqrt(features.noise_m2);
}

Features featuresOf(
    const layers::HeightSlabs& slabs, const layers::HeightSlab* lowest, const SlabReading& reading)
{
  Features f;
  lowest = fromFloor(slabs, lowest, reading);
  if (lowest == nullptr)
  {
    return f;
  }
  const int64_t base_mm = int64_t{lowest->level} * reading.slab_mm;
  int64_t top_mm = base_mm;
  Sums sums;
  f.last_seen = lowest->last_seen;
  for (const layers::HeightSlab* s = lowest; s != nullptr; s = slabs.get(s->next))
  {
    const int64_t bottom_mm = int64_t{s->level} * reading.slab_mm;
    const int64_t gap_mm = bottom_mm + s->min_z_mm - top_mm;
    if (s != lowest && reading.ignore_overhangs && gap_mm >= reading.clearance_mm)
    {
      break;
    }
    top_mm = bottom_mm + s->max_z_mm;
    f.n += s->n;
    f.level_n += s->level_n;
    f.last_seen = std::max(f.last_seen, s->last_seen);
    sums.add(*s, static_cast<double>(bottom_mm - base_mm));
  }
  // Whole numbers divided once: 30 mm are 0.03 m to the last bit, and meet a limit of 0.03 m.
  const auto base = static_cast<double>(base_mm);
  const double n = sums.n;
  const double up = n * static_cast<double>(top_mm - base_mm) - sums.z;
  const double down = sums.z - n * lowest->min_z_mm;
  const double squares = n * sums.zz - sums.z * sums.z;
  f.mean_m = (base + sums.z / n) / kMmPerM;  // (1)
  f.min_m = (base + lowest->min_z_mm) / kMmPerM;
  f.max_m = static_cast<double>(top_mm) / kMmPerM;
  f.deviation_m = std::max(up, down) / n / kMmPerM;                        // (2)
  f.variance_m2 = std::max(0.0, squares) / (n * n) / (kMmPerM * kMmPerM);  // (5)
  f.noise_m2 = sums.noise / n / kNoisePerM2;
  f.residual_m2 = f.variance_m2;
  fitPlane(sums, base, reading.thin_mm, f);  // (3)
  return f;
}

Classifier::Classifier(const Params& params) :
    kind_(params.classifier), min_points_(static_cast<uint64_t>(params.min_points)), limits_()
{
  const std::array<ClassLimits, 3> given = {
      params.flat, params.small_roughness, params.large_roughness};
  for (size_t i = 0; i < given.size(); ++i)
  {
    limits_[i] = {given[i].deviation_m, tan2(given[i].slope_deg), given[i].variance_m2};
  }
}

Class Classifier::worstOf(double deviation_m, double variance_m2, double tan2_slope) const
{
  for (size_t i = 0; i < limits_.size(); ++i)
  {
    const Limits& most = limits_[i];
    if (deviation_m <= most.deviation_m && variance_m2 <= most.variance_m2 &&
        tan2_slope <= most.tan2_slope)
    {
      return static_cast<Class>(static_cast<size_t>(Class::flat) + i);
    }
  }
  return Class::obstacle;
}

Class Classifier::operator()(const Features& f) const
{
  if (f.n < min_points_)
  {
    return Class::undefined;
  }
  if (kind_ == ClassifierKind::standard)
  {
    return worstOf(
        f.deviation_m - noiseSpan_m(f), f.variance_m2 - f.noise_m2,
        f.has_plane ? f.tan2Slope() : 0);
  }
  if (f.has_plane)
  {
    return worstOf(f.deviation_m, f.variance_m2, f.tan2Slope());
  }
  const Class without_slope = worstOf(f.deviation_m, f.variance_m2, 0);
  return without_slope == Class::obstacle ? Class::obstacle : Class::undefined;
}

uint8_t indexOf(Class of, const Params& params)
{
  switch (of)
  {
    case Class::flat:
      return static_cast<uint8_t>(params.index_flat);
    case Class::small_roughness:
      return static_cast<uint8_t>(params.index_small_roughness);
    case Class::large_roughness:
      return static_cast<uint8_t>(params.index_large_roughness);
    case Class::obstacle:
      return 100;
    case Class::undefined:
      break;
  }
  return kNoIndex;
}
}  // namespace traverse::traversability_grid
