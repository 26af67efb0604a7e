// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "beam_points.h"

#include "azimuth.h"

#include <traverse/geometry/clones.h>
#include <traverse/geometry/lattice.h>

namespace traverse::multi_lidar_grid
{
namespace
{
constexpr double kMm = geometry::kMillimetresPerMetre;
constexpr double kMostHeight_mm = 1e6;

/** As llround(). */
inline double nearestWhole(double x)
{
  constexpr double kBelowHalf = 0.49999999999999994;
  return __builtin_trunc(x + __builtin_copysign(kBelowHalf, x));
}

/** x where it is within [low, high], else the nearer bound; low for NaN. */
inline double bounded(double x, double low, double high)
{
  const double not_below = x > low ? x : low;
  return not_below < high ? not_below : high;
}

inline float boundedF(float x, float low, float high)
{
  const float not_below = x > low ? x : low;
  return not_below < high ? not_below : high;
}

inline bool isNear(double metres)
{
  return __builtin_fabs(metres) <= geometry::kFarthest_m;
}
}  // namespace

TRAVERSE_CLONES
void locate(const BeamFrame& frame, const PointArrays& in, BeamPoints& points)
{
  const BeamFrame& f = frame;
  const auto& T = f.T;
  const double by_cell = 1.0 / f.cell_mm;
  const double side_mm = static_cast<double>(f.edge) * f.cell_mm;
  const double corner_x = f.min_x_mm / kMm;
  const double corner_y = f.min_y_mm / kMm;
  const double corner_z = f.zero_mm / kMm;
  const float last_origin = static_cast<float>(f.origins - 1);
  const bool moves = f.origins > 1 && in.time_s != nullptr;
  const float* time_s = moves ? in.time_s : in.x;
  const float by_step = moves ? f.by_step : 0.0F;
  const int32_t next = moves ? 1 : 0;
  const int32_t most_before = moves ? f.origins - 2 : 0;
  uint64_t bad = 0;
  uint64_t inside = 0;
  int32_t* const out_cell = points.cell.data();
  int32_t* const out_z = points.z_mm.data();
  float* const out_reach = points.reach_m.data();
  float* const out_slope = points.slope.data();
  float* const out_turn = points.turn.data();
  for (size_t i = 0; i < in.size; ++i)
  {
    const double px = in.x[i];
    const double py = in.y[i];
    const double pz = in.z[i];
    const double x = T[0][0] * px + T[0][1] * py + T[0][2] * pz + T[0][3];
    const double y = T[1][0] * px + T[1][1] * py + T[1][2] * pz + T[1][3];
    const double z = T[2][0] * px + T[2][1] * py + T[2][2] * pz + T[2][3];
    const double x_mm = bounded(nearestWhole(x * kMm) - f.min_x_mm, -1, side_mm);
    const double y_mm = bounded(nearestWhole(y * kMm) - f.min_y_mm, -1, side_mm);
    const double z_mm = bounded(nearestWhole(z * kMm) - f.zero_mm, -kMostHeight_mm, kMostHeight_mm);
    const auto column = static_cast<int32_t>((x_mm + 0.5) * by_cell);
    const auto row = static_cast<int32_t>((y_mm + 0.5) * by_cell);

    const float steps = boundedF((time_s[i] - f.first_s) * by_step, 0.0F, last_origin);
    const auto whole = static_cast<int32_t>(steps);
    const int32_t before = whole < most_before ? whole : most_before;
    const float part = (steps - static_cast<float>(before)) * static_cast<float>(next);
    const auto a = static_cast<size_t>(before);
    const auto b = static_cast<size_t>(before + next);
    const float ox = f.x_m[a] + part * (f.x_m[b] - f.x_m[a]);
    const float oy = f.y_m[a] + part * (f.y_m[b] - f.y_m[a]);
    const float oz = f.z_m[a] + part * (f.z_m[b] - f.z_m[a]);
    const auto dx = static_cast<float>(x - corner_x) - ox;
    const auto dy = static_cast<float>(y - corner_y) - oy;
    const auto dz = static_cast<float>(z - corner_z) - oz;
    const float along2 = dx * dx + dy * dy;
    const float reach = __builtin_sqrtf(along2);

    const float first = dx * f.first_normal[0] + dy * f.first_normal[1] + dz * f.first_normal[2];
    const float last = dx * f.last_normal[0] + dy * f.last_normal[1] + dz * f.last_normal[2];
    // & and | and not && and ||, because it must not branch.
    const bool after_first = first >= 0;
    const bool before_last = last >= 0;
    const bool in_view =
        !f.has_view | (f.is_wide ? (after_first | before_last) : (after_first & before_last));
    const bool is_good = isNear(x) & isNear(y) & isNear(z);
    const bool in_range = static_cast<double>(along2 + dz * dz) <= f.range2_m2;
    const bool in_region = (x_mm >= 0) & (x_mm < side_mm) & (y_mm >= 0) & (y_mm < side_mm) &
                           (z_mm > -kMostHeight_mm) & (z_mm < kMostHeight_mm);
    const bool is_inside = is_good & in_view & in_range & in_region;
    const bool is_beam = is_good & in_view & (static_cast<double>(along2) >= f.least2_m2);
    out_cell[i] = is_inside ? row * f.edge + column : BeamPoints::kNoCell;
    out_z[i] = static_cast<int32_t>(z_mm);
    out_reach[i] = is_beam ? reach : -1.0F;
    out_slope[i] = dz / (is_beam ? reach : 1.0F);
    out_turn[i] = turnOf(is_beam ? dx : 1.0F, is_beam ? dy : 0.0F);
    bad += is_good ? 0U : 1U;
    inside += is_inside ? 1U : 0U;
  }
  points.bad = bad;
  points.inside = inside;
}

void BeamPoints::resize(size_t n)
{
  size = n;
  if (cell.size() < n)
  {
    cell.resize(n);
    z_mm.resize(n);
    reach_m.resize(n);
    slope.resize(n);
    turn.resize(n);
  }
}
}  // namespace traverse::multi_lidar_grid
