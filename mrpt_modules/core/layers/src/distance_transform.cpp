// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#include <traverse/layers/distance_transform.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace traverse::layers
{
namespace
{
int32_t checkedRows(size_t cells, int32_t columns, int32_t most_squared)
{
  constexpr int32_t kMost =
      DistanceTransform::kLongestReach_cells * DistanceTransform::kLongestReach_cells;
  if (columns < 1 || cells % static_cast<size_t>(columns) != 0)
  {
    throw std::invalid_argument("the cells must be full rows of one column or more");
  }
  if (most_squared < 0 || most_squared > kMost)
  {
    throw std::invalid_argument("distances reach 0 to 16383 cells");
  }
  const size_t rows = cells / static_cast<size_t>(columns);
  if (std::max<size_t>(static_cast<size_t>(columns), rows) > size_t{1} << 24)
  {
    throw std::invalid_argument("a side may have 2^24 cells");
  }
  return static_cast<int32_t>(rows);
}

int64_t squared(int64_t v)
{
  return v * v;
}

/** How many columns away an obstacle may be that is 0, 1, 2 ... rows away. */
std::vector<int16_t> reachByRows(int32_t most_squared)
{
  std::vector<int16_t> reach;
  int32_t across = DistanceTransform::kLongestReach_cells;
  for (int32_t rows = 0; rows * rows <= most_squared; ++rows)
  {
    while (across * across + rows * rows > most_squared)
    {
      --across;
    }
    reach.push_back(static_cast<int16_t>(across));
  }
  return reach;
}
}  // namespace

DistanceTransform::DistanceTransform(
    std::span<const uint8_t> obstacles, int32_t columns, int32_t most_squared) :
    columns_(columns),
    rows_(checkedRows(obstacles.size(), columns, most_squared)),
    reach_by_rows_(reachByRows(most_squared)),
    along_(obstacles.size()),
    envelope_(static_cast<size_t>(columns))
{
  const auto width = static_cast<size_t>(columns);
  const auto beyond = static_cast<int16_t>(reach_by_rows_.size());
  std::vector<int16_t> nearest(width, beyond);
  for (size_t begin = 0; begin < along_.size(); begin += width)
  {
    const uint8_t* const obstacle = obstacles.data() + begin;
    int16_t* const along = along_.data() + begin;
    for (size_t x = 0; x < width; ++x)
    {
      const auto next = static_cast<int16_t>(std::min<int>(nearest[x] + 1, beyond));
      nearest[x] = obstacle[x] != 0 ? int16_t{0} : next;
      along[x] = static_cast<int16_t>(-nearest[x]);
    }
  }
  std::fill(nearest.begin(), nearest.end(), beyond);
  for (size_t end = along_.size(); end > 0; end -= width)
  {
    int16_t* const along = along_.data() + end - width;
    for (size_t x = 0; x < width; ++x)
    {
      const auto next = static_cast<int16_t>(std::min<int>(nearest[x] + 1, beyond));
      nearest[x] = along[x] == 0 ? int16_t{0} : next;
      along[x] = nearest[x] < -along[x] ? nearest[x] : along[x];
    }
  }
}

/** The columns' nearest obstacles as parabolas over the row, (x - column)^2 + rows^2: which of them
 * is the lowest, from left to right. */
size_t DistanceTransform::findEnvelope(const int16_t* along)
{
  const auto beyond = static_cast<int32_t>(reach_by_rows_.size());
  const auto height = [&](int32_t column) { return squared(along[column]); };
  const auto value = [&](int32_t x, int32_t column)
  { return squared(int64_t{x} - column) + height(column); };
  size_t n = 0;
  for (int32_t u = 0; u < columns_; ++u)
  {
    if (std::abs(along[u]) == beyond)
    {
      continue;
    }
    while (n > 0 && value(envelope_[n - 1].first, envelope_[n - 1].column) >
                        value(envelope_[n - 1].first, u))
    {
      --n;
    }
    int64_t first = 0;
    if (n > 0)
    {
      const int64_t v = envelope_[n - 1].column;
      const int64_t rise = squared(u) - squared(v) + height(u) - height(static_cast<int32_t>(v));
      first = geometry::floorDiv(rise, 2 * (u - v)) + 1;  // where u is lower, not as low
    }
    if (first < columns_)
    {
      envelope_[n++] = {u, static_cast<int32_t>(first)};
    }
  }
  return n;
}

void DistanceTransform::row(int32_t y, NearestRow& nearest)
{
  const auto width = static_cast<size_t>(columns_);
  nearest.squared.assign(width, NearestRow::kNone);
  nearest.dx.assign(width, 0);
  nearest.dy.assign(width, 0);
  const int16_t* const along = along_.data() + static_cast<size_t>(y) * width;
  int32_t end = columns_;
  for (size_t n = findEnvelope(along); n > 0; --n)
  {
    const auto [column, first] = envelope_[n - 1];
    const int16_t dy = along[column];
    const int32_t reach = reach_by_rows_[static_cast<size_t>(std::abs(dy))];
    const int32_t stop = std::min(end, column + reach + 1);
    for (int32_t x = std::max(first, column - reach); x < stop; ++x)
    {
      const int32_t dx = column - x;
      nearest.squared[static_cast<size_t>(x)] = dx * dx + dy * dy;
      nearest.dx[static_cast<size_t>(x)] = static_cast<int16_t>(dx);
      nearest.dy[static_cast<size_t>(x)] = dy;
    }
    end = first;
  }
}
}  // namespace traverse::layers
