// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

namespace traverse::geometry
{
/** Integer coordinates are millimetres of the map frame; exact to beyond 1e7 m. */
using Millimetres = int64_t;

inline constexpr double kMillimetresPerMetre = 1000.0;

/** Coordinates beyond this are refused by callers: nothing on the ground is there. */
inline constexpr double kFarthest_m = 1e8;

/** Nearest millimetre, halves away from zero. |metres| <= kFarthest_m, finite. */
inline Millimetres toMillimetres(double metres)
{
  return std::llround(metres * kMillimetresPerMetre);
}

/** Quotient rounded to minus infinity; divisor > 0. */
inline constexpr int64_t floorDiv(int64_t dividend, int64_t divisor)
{
  const int64_t quotient = dividend / divisor;
  return quotient - static_cast<int64_t>(dividend % divisor < 0);
}

/** Remainder of floorDiv, in [0, divisor). */
inline constexpr int64_t floorMod(int64_t dividend, int64_t divisor)
{
  return dividend - floorDiv(dividend, divisor) * divisor;
}

/** Column (along x) and row (along y) of a cell. Cell (i, j) covers the half-open square
 * [i, i+1) x [j, j+1) cell edges from map zero, so an index means the same place in every map. */
struct CellIndex
{
  int32_t x = 0;
  int32_t y = 0;
  friend bool operator==(const CellIndex&, const CellIndex&) = default;
};

/** Half-open rectangle of cells [min, max). */
struct CellRect
{
  CellIndex min;
  CellIndex max;

  int32_t width() const { return max.x - min.x; }

  int32_t height() const { return max.y - min.y; }

  bool empty() const { return width() <= 0 || height() <= 0; }

  bool contains(CellIndex c) const
  {
    return c.x >= min.x && c.x < max.x && c.y >= min.y && c.y < max.y;
  }

  friend bool operator==(const CellRect&, const CellRect&) = default;
};

/** The cells of both; CellRect{} where there are none. */
inline CellRect intersection(const CellRect& a, const CellRect& b)
{
  const CellRect both = {
      {a.min.x > b.min.x ? a.min.x : b.min.x, a.min.y > b.min.y ? a.min.y : b.min.y},
      {a.max.x < b.max.x ? a.max.x : b.max.x, a.max.y < b.max.y ? a.max.y : b.max.y}};
  const bool is_empty = both.max.x <= both.min.x || both.max.y <= both.min.y;
  return is_empty ? CellRect{} : both;
}

/** The smallest rectangle around both; an empty one adds nothing. */
inline CellRect bounding(const CellRect& a, const CellRect& b)
{
  if (a.empty() || b.empty())
  {
    return a.empty() ? b : a;
  }
  return {
      {a.min.x < b.min.x ? a.min.x : b.min.x, a.min.y < b.min.y ? a.min.y : b.min.y},
      {a.max.x > b.max.x ? a.max.x : b.max.x, a.max.y > b.max.y ? a.max.y : b.max.y}};
}

/** The absolute lattice of square cells on which maps lie: cell edges at multiples of cell_mm from
 * map zero, whatever the map's extent. */
struct Lattice
{
  int32_t cell_mm = 200;

  double cell_m() const { return cell_mm / kMillimetresPerMetre; }

  CellIndex cellOf(Millimetres x_mm, Millimetres y_mm) const
  {
    return {
        static_cast<int32_t>(floorDiv(x_mm, cell_mm)),
        static_cast<int32_t>(floorDiv(y_mm, cell_mm))};
  }

  /** Smallest x (or y) of column (or row) i, metres in the map frame. */
  double edge_m(int32_t i) const
  {
    return static_cast<double>(int64_t{i} * cell_mm) / kMillimetresPerMetre;
  }

  double centre_m(int32_t i) const { return edge_m(i) + cell_m() / 2; }

  friend bool operator==(const Lattice&, const Lattice&) = default;
};
}  // namespace traverse::geometry
