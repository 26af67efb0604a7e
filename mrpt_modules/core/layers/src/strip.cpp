// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "strip.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace traverse::layers
{
namespace
{
// Obstacle cells nearer to each other than this are one thing to any vehicle; their gap would be a
// matter of how a wall falls on the cells.
constexpr int64_t kLeastApart_cells = 3;

constexpr double kHalfDiagonal = 0.7;  // of a unit square, rounded down

constexpr uint8_t kLeft = 1;
constexpr uint8_t kBelow = 2;
constexpr size_t kWord = sizeof(uint64_t);

size_t roundedUp(size_t n)
{
  return (n + kWord - 1) / kWord * kWord;
}

int64_t squared(int64_t v)
{
  return v * v;
}

/** Within 5/6 of a cell of the bisector of two obstacles, where the squared distances from them
 * differ by so much; a line's cells that touch by their sides are within 0.71. */
bool isOnBisector(int64_t difference, int64_t apart_squared)
{
  return 9 * squared(difference) <= 25 * apart_squared;
}
}  // namespace

Strip::Strip(const Buffer& buffer, int32_t hard_squared) :
    buffer_(buffer),
    least_apart_(static_cast<int16_t>(
        std::max(kLeastApart_cells * kHalfDiagonal, std::sqrt(hard_squared) * kHalfDiagonal))),
    wide_apart_squared_(std::max<int64_t>(squared(kLeastApart_cells), 4 * int64_t{hard_squared})),
    ridge_(buffer)
{
}

/** The directions, by 120 degrees or more: their cosine is at most -1/2. And that also if one
 * obstacle is a cell nearer to the other than it seems, as by how walls fall on cells: from each
 * other they are twice the sine of 60 degrees as far as from here. */
bool Strip::differ(const Side& a, const Side& b, int64_t apart_squared)
{
  const int64_t dot = int64_t{a.dx} * b.dx + int64_t{a.dy} * b.dy;
  if (dot >= 0 || 4 * squared(dot) < int64_t{a.squared} * b.squared)
  {
    return false;
  }
  constexpr float kSine = 0.8660254F;
  const auto root = [](int64_t v) { return std::sqrt(static_cast<float>(v)); };
  return root(apart_squared) - 1 >= kSine * (root(a.squared) + root(b.squared));
}

/** b lies (step_x, step_y) from a. */
void Strip::addPair(const Side& a, const Side& b, int32_t step_x, int32_t step_y)
{
  if (a.squared == NearestRow::kNone || b.squared == NearestRow::kNone ||
      !(buffer_.isSoft(a.cell) || buffer_.isSoft(b.cell)))
  {
    return;
  }
  const int64_t apart_squared = squared(b.dx + step_x - a.dx) + squared(b.dy + step_y - a.dy);
  if (apart_squared < squared(kLeastApart_cells))
  {
    return;
  }
  if (differ(a, b, apart_squared))
  {
    const int64_t off_a = squared(b.dx + step_x) + squared(b.dy + step_y) - a.squared;
    const int64_t off_b = squared(a.dx - step_x) + squared(a.dy - step_y) - b.squared;
    ridge_.add(a.cell, a.squared, isOnBisector(off_a, apart_squared) || !buffer_.isSoft(b.cell));
    ridge_.add(b.cell, b.squared, isOnBisector(off_b, apart_squared) || !buffer_.isSoft(a.cell));
  }
  else if (apart_squared >= wide_apart_squared_)
  {
    ridge_.add(a.cell, a.squared, false);
    ridge_.add(b.cell, b.squared, false);
  }
}

/** Which pairs with a cell may have obstacles that lie apart, by the longer of columns and rows
 * between these: kLeft, kBelow. Most have not. */
void Strip::findApart(const NearestRow& now, const NearestRow& before)
{
  const auto longer = [](int across, int along)
  { return static_cast<int16_t>(std::max(std::abs(across), std::abs(along))); };
  const int16_t least = least_apart_;
  const size_t columns = buffer_.columns;
  apart_.assign(roundedUp(columns), 0);
  uint8_t* const marks = apart_.data();  // bytes: not known to the compiler not to be the vectors
  const int16_t* const dx = now.dx.data();
  const int16_t* const dy = now.dy.data();
  for (size_t x = 1; x < columns; ++x)
  {
    marks[x] = longer(dx[x] - dx[x - 1] + 1, dy[x] - dy[x - 1]) >= least ? kLeft : uint8_t{0};
  }
  if (before.dx.size() != columns)
  {
    return;
  }
  const int16_t* const dx_before = before.dx.data();
  const int16_t* const dy_before = before.dy.data();
  for (size_t x = 0; x < columns; ++x)
  {
    const bool is_apart = longer(dx[x] - dx_before[x], dy[x] - dy_before[x] + 1) >= least;
    marks[x] = static_cast<uint8_t>(marks[x] | (is_apart ? kBelow : uint8_t{0}));
  }
}

void Strip::addRow(size_t y, const NearestRow& now, const NearestRow& before)
{
  findApart(now, before);
  const size_t begin = y * buffer_.columns;
  const auto side = [](const NearestRow& row, size_t row_begin, size_t x) {
    return Side{row_begin + x, row.squared[x], row.dx[x], row.dy[x]};
  };
  for (size_t word = 0; word < apart_.size(); word += kWord)
  {
    uint64_t any = 0;
    std::memcpy(&any, &apart_[word], kWord);
    for (size_t x = word; any != 0 && x < word + kWord; ++x)
    {
      if ((apart_[x] & kLeft) != 0)
      {
        addPair(side(now, begin, x - 1), side(now, begin, x), 1, 0);
      }
      if ((apart_[x] & kBelow) != 0)
      {
        addPair(side(before, begin - buffer_.columns, x), side(now, begin, x), 0, 1);
      }
    }
  }
}
}  // namespace traverse::layers
