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
constexpr double kFar_m = 1e9;

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

inline bool isIn(int32_t x, int32_t end)
{
  return static_cast<uint32_t>(x) < static_cast<uint32_t>(end);
}

inline bool isNear(double metres)
{
  return __builtin_fabs(metres) <= geometry::kFarthest_m;
}

/** Points are worked on in pieces that stay near. */
constexpr size_t kPiece = 512;

struct Piece
{
  float x_m[kPiece];  // from the region's corner and the heights' zero
  float y_m[kPiece];
  float z_m[kPiece];
  float from_x_m[kPiece];  // the sensor at the point's time
  float from_y_m[kPiece];
  float from_z_m[kPiece];
  int32_t is_good[kPiece];
};

// The three loops of a piece. & and | and not && and ||, because they must not branch.

inline void toCells(
    const BeamFrame& frame,
    const PointArrays& in,
    int32_t* __restrict cell,
    int32_t* __restrict height,
    Piece& __restrict piece)
{
  const BeamFrame f = frame;
  const auto& T = f.to_map;
  const float* __restrict const in_x = in.x;
  const float* __restrict const in_y = in.y;
  const float* __restrict const in_z = in.z;
  const size_t size = in.size;
  const double by_cell = 1.0 / f.cell_mm;
  const double side_mm = static_cast<double>(f.edge) * f.cell_mm;
  const auto side = static_cast<int32_t>(side_mm);
  const double depth_mm = 2 * f.most_mm;
  const double lowest_mm = f.zero_mm - f.most_mm;
  const auto depth = static_cast<int32_t>(depth_mm);
  const auto most = static_cast<int32_t>(f.most_mm);
  const double corner_x = f.min_x_mm / kMm;
  const double corner_y = f.min_y_mm / kMm;
  const double corner_z = f.zero_mm / kMm;
  for (size_t i = 0; i < size; ++i)
  {
    const double px = in_x[i];
    const double py = in_y[i];
    const double pz = in_z[i];
    const double x = T[0][0] * px + T[0][1] * py + T[0][2] * pz + T[0][3];
    const double y = T[1][0] * px + T[1][1] * py + T[1][2] * pz + T[1][3];
    const double z = T[2][0] * px + T[2][1] * py + T[2][2] * pz + T[2][3];
    const double x_mm = bounded(nearestWhole(x * kMm) - f.min_x_mm, -1, side_mm);
    const double y_mm = bounded(nearestWhole(y * kMm) - f.min_y_mm, -1, side_mm);
    const double z_mm = bounded(nearestWhole(z * kMm) - lowest_mm, -1, depth_mm);
    const auto column = static_cast<int32_t>((x_mm + 0.5) * by_cell);
    const auto row = static_cast<int32_t>((y_mm + 0.5) * by_cell);
    const bool is_good = isNear(x) & isNear(y) & isNear(z);
    // By whole numbers: of comparisons with the bounds again the compiler makes branches.
    const auto from_x = static_cast<int32_t>(x_mm);
    const auto from_y = static_cast<int32_t>(y_mm);
    const auto from_z = static_cast<int32_t>(z_mm);
    const bool in_region = isIn(from_x, side) & isIn(from_y, side) & isIn(from_z, depth);
    cell[i] = is_good & in_region ? row * f.edge + column : BeamPoints::kNoCell;
    height[i] = from_z - most;
    piece.x_m[i] = static_cast<float>(bounded(x - corner_x, -kFar_m, kFar_m));
    piece.y_m[i] = static_cast<float>(bounded(y - corner_y, -kFar_m, kFar_m));
    piece.z_m[i] = static_cast<float>(bounded(z - corner_z, -kFar_m, kFar_m));
    piece.is_good[i] = is_good ? 1 : 0;
  }
}

inline void toOrigins(
    const BeamFrame& frame, const float* __restrict time_s, size_t size, Piece& __restrict piece)
{
  const BeamFrame& f = frame;
  const auto last = static_cast<float>(f.origins - 1);
  const int32_t most_before = f.origins - 2;
  for (size_t i = 0; i < size; ++i)
  {
    const float steps = boundedF((time_s[i] - f.first_s) * f.by_step, 0.0F, last);
    const auto whole = static_cast<int32_t>(steps);
    const int32_t a = whole < most_before ? whole : most_before;
    const float part = steps - static_cast<float>(a);
    piece.from_x_m[i] = f.x_m[a] + part * (f.x_m[a + 1] - f.x_m[a]);
    piece.from_y_m[i] = f.y_m[a] + part * (f.y_m[a + 1] - f.y_m[a]);
    piece.from_z_m[i] = f.z_m[a] + part * (f.z_m[a + 1] - f.z_m[a]);
  }
}

inline void stay(const BeamFrame& f, Piece& piece)
{
  for (size_t i = 0; i < kPiece; ++i)
  {
    piece.from_x_m[i] = f.x_m[0];
    piece.from_y_m[i] = f.y_m[0];
    piece.from_z_m[i] = f.z_m[0];
  }
}

struct BeamArrays
{
  int32_t* cell;
  float* reach_m;
  float* slope;
  float* turn;
};

inline void toBeams(
    const BeamFrame& frame, const Piece& __restrict piece, size_t size, const BeamArrays& out)
{
  const BeamFrame f = frame;
  int32_t* __restrict const cell = out.cell;
  float* __restrict const reach_m = out.reach_m;
  float* __restrict const slope = out.slope;
  float* __restrict const turn = out.turn;
  const auto range2 = static_cast<float>(f.range2_m2);
  const auto least2 = static_cast<float>(f.least2_m2);
  const bool sees_all = !f.has_view;
  for (size_t i = 0; i < size; ++i)
  {
    const float dx = piece.x_m[i] - piece.from_x_m[i];
    const float dy = piece.y_m[i] - piece.from_y_m[i];
    const float dz = piece.z_m[i] - piece.from_z_m[i];
    const float along2 = dx * dx + dy * dy;
    const float first = dx * f.first_normal[0] + dy * f.first_normal[1] + dz * f.first_normal[2];
    const float last = dx * f.last_normal[0] + dy * f.last_normal[1] + dz * f.last_normal[2];
    const bool after_first = first >= 0;
    const bool before_last = last >= 0;
    const bool in_view =
        sees_all | (after_first & before_last) | (f.is_wide & (after_first | before_last));
    const bool is_beam = (piece.is_good[i] != 0) & in_view & (along2 >= least2);
    const bool is_kept = in_view & (along2 + dz * dz <= range2);
    const float reach = __builtin_sqrtf(is_beam ? along2 : 1.0F);
    cell[i] = is_kept ? cell[i] : BeamPoints::kNoCell;
    reach_m[i] = is_beam ? reach : -1.0F;
    slope[i] = dz / reach;
    turn[i] = turnOf(is_beam ? dx : 1.0F, is_beam ? dy : 0.0F);
  }
}

inline void count(const Piece& piece, const int32_t* cell, size_t size, BeamPoints& points)
{
  uint32_t good = 0;
  uint32_t inside = 0;
  for (size_t i = 0; i < size; ++i)
  {
    good += static_cast<uint32_t>(piece.is_good[i]);
    inside += cell[i] >= 0 ? 1U : 0U;
  }
  points.bad += size - good;
  points.inside += inside;
}
}  // namespace

TRAVERSE_CLONES
void locate(const BeamFrame& frame, const PointArrays& in, BeamPoints& points)
{
  points.bad = 0;
  points.inside = 0;
  const bool moves = frame.origins > 1 && in.time_s != nullptr;
  Piece piece{};
  stay(frame, piece);
  for (size_t first = 0; first < in.size; first += kPiece)
  {
    const size_t size = in.size - first < kPiece ? in.size - first : kPiece;
    int32_t* const cell = points.cell.data() + first;
    const PointArrays part = {in.x + first, in.y + first, in.z + first, nullptr, size};
    toCells(frame, part, cell, points.z_mm.data() + first, piece);
    if (moves)
    {
      toOrigins(frame, in.time_s + first, size, piece);
    }
    toBeams(
        frame, piece, size,
        {cell, points.reach_m.data() + first, points.slope.data() + first,
         points.turn.data() + first});
    count(piece, cell, size, points);
  }
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
