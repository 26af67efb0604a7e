// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "spread.h"

#include <traverse/geometry/exact_trig.h>

#include <algorithm>
#include <cmath>

namespace traverse::ground
{
namespace
{
/** Where nothing is measured a slope fades by this from patch to patch. */
constexpr float kFade = 0.8F;

/** Weight of the predicted slope beside the measured one, square metres. */
constexpr float kSlopePrior = 4;
}  // namespace

Spread::Spread(PatchGrid& grid, const Params& params) :
    grid_(grid),
    params_(params),
    most_slope_(
        static_cast<float>(geometry::tangentOf(params.most_slope_deg * geometry::kPi / 180))),
    around_()
{
  size_t count = 0;
  for (const int32_t radius : {1, 2})
  {
    const int32_t edge = 2 * radius + 1;
    for (int32_t i = 0; i < edge * edge; ++i)
    {
      const int32_t x = i % edge - radius;
      const int32_t y = i / edge - radius;
      if (std::max(std::abs(x), std::abs(y)) == radius)
      {
        around_[count++] = neighbour(x, y);
      }
    }
  }
}

Spread::Neighbour Spread::neighbour(int32_t x, int32_t y) const
{
  const auto square = static_cast<float>(x * x + y * y);
  const float side = grid_.side_m();
  const float x_m = static_cast<float>(x) * side;
  const float y_m = static_cast<float>(y) * side;
  return {
      Quad{x_m, 0, 0, 0},     Quad{y_m, 0, 0, 0},       Quad{x_m * x_m, x_m * y_m, y_m * y_m, 0},
      y * grid_.stride() + x, std::sqrt(square) * side, 1 / square};
}

void Spread::plant(const Seed& seed)
{
  const PatchGrid::Position middle = grid_.positionOf(seed.x_m, seed.y_m);
  const float side = grid_.side_m();
  const auto reach = static_cast<int32_t>(seed.radius_m / side) + 1;
  const auto column = static_cast<int32_t>(std::lround(middle.x));
  const auto row = static_cast<int32_t>(std::lround(middle.y));
  for (int32_t y = row - reach; y <= row + reach; ++y)
  {
    for (int32_t x = column - reach; x <= column + reach; ++x)
    {
      const float dx = (static_cast<float>(x) - middle.x) * side;
      const float dy = (static_cast<float>(y) - middle.y) * side;
      const float distance = std::sqrt(dx * dx + dy * dy);
      const int32_t i = grid_.patchAt(x, y);
      const bool is_seed = distance <= seed.radius_m || (x == column && y == row);
      if (i < 0 || !is_seed || !grid_.isOpen(i))
      {
        continue;
      }
      push(i);
      const float z_m = seed.z_m + seed.slope_x * dx + seed.slope_y * dy;
      settleColumns(i, {Quad{z_m, seed.slope_x, seed.slope_y, 0}, distance});
    }
  }
}

inline void Spread::pushAround(int32_t patch)
{
  for (size_t k = 0; k < kNearest; ++k)
  {
    const int32_t next = patch + around_[k].offset;
    if (grid_.isOpen(next))
    {
      push(next);
    }
  }
}

inline void Spread::push(int32_t patch)
{
  grid_.close(patch);
  queue_.push_back(patch);
}

template <size_t count>
inline Spread::Prediction Spread::predict(int32_t i) const
{
  float weights = 0;
  Prediction sum{Quad{}, Patch::kFar};
  for (size_t k = 0; k < count; ++k)  // without a branch: who is not settled has no trust
  {
    const Neighbour& n = around_[k];
    const Patch& p = grid_.at(i + n.offset);
    const float w = n.weight * p.trust();
    weights += w;
    sum.plane += w * (p.plane - p.slopeX() * n.x_m - p.slopeY() * n.y_m);
    sum.gap_m = std::min(sum.gap_m, p.gap_m + n.distance_m);
  }
  sum.plane /= weights;
  return sum;
}

inline void Spread::settle(int32_t i, const Prediction& predicted)
{
  constexpr Quad kFaded = {1, kFade, kFade, 0};
  put(i, kFaded * predicted.plane, predicted.gap_m);
}

inline void Spread::put(int32_t i, Quad plane, float gap_m)
{
  plane[3] = 1 / (1 + gap_m);
  grid_.at(i).plane = plane;
  grid_.at(i).gap_m = gap_m;
}

void Spread::settleColumns(int32_t i, const Prediction& predicted)
{
  findCandidates(grid_.at(i), predicted);
  if (candidates_.empty())
  {
    settle(i, predicted);
    return;
  }
  grid_.at(i).measured = 1;
  put(i, fitSlope(i, lowestSurface(predicted), predicted), 0);
}

void Spread::from(std::span<const Seed> seeds)
{
  for (const Seed& seed : seeds)
  {
    plant(seed);
  }
  const size_t planted = queue_.size();
  for (size_t i = 0; i < planted; ++i)
  {
    pushAround(queue_[i]);
  }
  for (size_t i = planted; i < queue_.size(); ++i)
  {
    const int32_t patch = queue_[i];
    if (grid_.at(patch).block < 0)
    {
      // Where there are no points the nearest patches will do.
      settle(patch, predict<kNearest>(patch));
    }
    else
    {
      settleColumns(patch, predict<kAround>(patch));
    }
    if (grid_.at(patch).gap_m < static_cast<float>(params_.most_gap_m))
    {
      pushAround(patch);
    }
  }
}

/** The plane with height z_m whose slopes fit the measured patches around and the prediction. */
Quad Spread::fitSlope(int32_t i, float z_m, const Prediction& predicted) const
{
  Quad squares = {kSlopePrior, 0, kSlopePrior, 0};
  float xz = kSlopePrior * predicted.slopeX();
  float yz = kSlopePrior * predicted.slopeY();
  for (const Neighbour& n : around_)  // without a branch: who is not measured counts 0 times
  {
    const Patch& p = grid_.at(i + n.offset);
    const float dz = p.measured * (p.z_m() - z_m);
    squares += p.measured * n.squares;
    xz += n.x_m[0] * dz;
    yz += n.y_m[0] * dz;
  }
  const float xx = squares[0];
  const float xy = squares[1];
  const float yy = squares[2];
  const float determinant = xx * yy - xy * xy;
  float slope_x = (xz * yy - yz * xy) / determinant;
  float slope_y = (yz * xx - xz * xy) / determinant;
  const float steepness = std::sqrt(slope_x * slope_x + slope_y * slope_y);
  if (steepness > most_slope_)
  {
    slope_x *= most_slope_ / steepness;
    slope_y *= most_slope_ / steepness;
  }
  return Quad{z_m, slope_x, slope_y, 0};
}
}  // namespace traverse::ground
