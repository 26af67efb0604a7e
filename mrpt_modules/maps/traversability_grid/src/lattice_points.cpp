// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/clones.h>
#include <traverse/geometry/lattice.h>
#include <traverse/traversability_grid/lattice_points.h>

namespace traverse::traversability_grid
{
namespace
{
/** What llround() gives: the largest number below one half carries halves, and nothing less, over
 * the next whole number, which truncation then leaves. */
inline double nearestWhole(double x)
{
  constexpr double kBelowHalf = 0.49999999999999994;
  return __builtin_trunc(x + __builtin_copysign(kBelowHalf, x));
}

/** x where it is in [0, end), else a number just outside; -1 for NaN. */
inline double within(double x, double end)
{
  const double not_below = x > -1 ? x : -1;
  return not_below < end ? not_below : end;
}

/** Quotients of whole numbers in [0, 2^31): half a unit more keeps rounding off the edges. */
inline int32_t quotient(double whole, double inverse)
{
  return static_cast<int32_t>((whole + 0.5) * inverse);
}

inline bool isIn(int32_t x, int32_t end)
{
  return static_cast<uint32_t>(x) < static_cast<uint32_t>(end);
}

inline bool isNear(double metres)
{
  return __builtin_fabs(metres) <= geometry::kFarthest_m;
}
}  // namespace

TRAVERSE_CLONES
void toLattice(
    const LatticeBox& box,
    const float* x,
    const float* y,
    const float* z,
    size_t size,
    LatticePoints& points)
{
  const LatticeBox b = box;
  const auto& T = b.T_map_base;
  const double by_cell = 1.0 / b.cell_mm;
  const double by_slab = 1.0 / b.slab_mm;
  constexpr double kMm = geometry::kMillimetresPerMetre;
  const auto width = static_cast<int32_t>(b.width_mm);
  const auto height = static_cast<int32_t>(b.height_mm);
  uint32_t bad = 0;
  uint32_t inside = 0;
  for (size_t i = 0; i < size; ++i)
  {
    const double px = x[i];
    const double py = y[i];
    const double pz = z[i];
    const double map_x = T[0][0] * px + T[0][1] * py + T[0][2] * pz + T[0][3];
    const double map_y = T[1][0] * px + T[1][1] * py + T[1][2] * pz + T[1][3];
    const double map_z = T[2][0] * px + T[2][1] * py + T[2][2] * pz + T[2][3];
    const double from_x = within(nearestWhole(map_x * kMm) - b.min_x_mm, b.width_mm);
    const double from_y = within(nearestWhole(map_y * kMm) - b.min_y_mm, b.height_mm);
    const double from_z = within(nearestWhole(map_z * kMm) - b.bottom_mm, b.depth_mm);
    const int32_t column = quotient(from_x, by_cell);
    const int32_t row = quotient(from_y, by_cell);
    const int32_t slab = quotient(from_z, by_slab);
    const auto x_mm = static_cast<int32_t>(from_x);
    const auto y_mm = static_cast<int32_t>(from_y);
    const auto z_mm = static_cast<int32_t>(from_z);
    // & and not &&, because it must not branch.
    const bool is_inside =
        (map_z >= b.lowest_m) & (map_z <= b.highest_m) & isIn(x_mm, width) & isIn(y_mm, height);
    points.column[i] = is_inside ? column : -1;
    points.row[i] = row;
    points.level[i] = b.bottom_level + slab;
    points.x_mm[i] = x_mm - column * b.cell_mm;
    points.y_mm[i] = y_mm - row * b.cell_mm;
    points.z_mm[i] = z_mm - slab * b.slab_mm;
    bad += isNear(map_x) & isNear(map_y) & isNear(map_z) ? 0U : 1U;
    inside += is_inside ? 1U : 0U;
  }
  points.size = size;
  points.bad = bad;
  points.outside = static_cast<uint32_t>(size) - bad - inside;
}
}  // namespace traverse::traversability_grid
