// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#include <traverse/layers/distance_transform.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace traverse::layers
{
namespace
{
// Short reaches: all columns within reach are looked at, 8 cells at a time. A candidate is its
// squared distance and its column in 15 bits, so that the least is the nearest, and the lower
// column of those equally near.
constexpr int32_t kNarrow = 15;
constexpr int32_t kColumnBits = 5;
constexpr int32_t kColumnMask = (1 << kColumnBits) - 1;
constexpr size_t kChunk = 32;

constexpr int16_t kNoSource = std::numeric_limits<int16_t>::max();

int32_t floorOfRoot(int32_t squared)
{
  int32_t root = 0;
  while ((root + 1) * (root + 1) <= squared)
  {
    ++root;
  }
  return root;
}

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

size_t roundedUp(size_t n)
{
  return (n + kChunk - 1) / kChunk * kChunk;
}
}  // namespace

DistanceTransform::DistanceTransform(
    std::span<const uint8_t> obstacles, int32_t columns, int32_t most_squared) :
    columns_(columns),
    rows_(checkedRows(obstacles.size(), columns, most_squared)),
    most_squared_(most_squared),
    reach_(floorOfRoot(most_squared)),
    is_narrow_(reach_ <= kNarrow),
    along_(obstacles.size()),
    source_(roundedUp(static_cast<size_t>(columns)))
{
  if (is_narrow_)
  {
    heights_.assign(
        source_.size() + 2 * static_cast<size_t>(reach_),
        static_cast<int16_t>((reach_ + 1) * (reach_ + 1) << kColumnBits));
  }
  else
  {
    envelope_.resize(static_cast<size_t>(columns));
  }
  findAlongColumns(obstacles);
}

void DistanceTransform::findAlongColumns(std::span<const uint8_t> obstacles)
{
  const auto columns = static_cast<size_t>(columns_);
  const auto beyond = static_cast<int16_t>(reach_ + 1);
  std::vector<int16_t> nearest(columns, beyond);
  for (size_t begin = 0; begin < along_.size(); begin += columns)
  {
    const uint8_t* const obstacle = obstacles.data() + begin;
    int16_t* const along = along_.data() + begin;
    for (size_t x = 0; x < columns; ++x)
    {
      const auto next = static_cast<int16_t>(std::min<int>(nearest[x] + 1, beyond));
      nearest[x] = obstacle[x] != 0 ? int16_t{0} : next;
      along[x] = static_cast<int16_t>(-nearest[x]);
    }
  }
  std::fill(nearest.begin(), nearest.end(), beyond);
  for (size_t begin = along_.size(); begin > 0; begin -= columns)
  {
    int16_t* const along = along_.data() + begin - columns;
    for (size_t x = 0; x < columns; ++x)
    {
      const auto next = static_cast<int16_t>(std::min<int>(nearest[x] + 1, beyond));
      nearest[x] = along[x] == 0 ? int16_t{0} : next;
      along[x] = nearest[x] < -along[x] ? nearest[x] : along[x];
    }
  }
}

void DistanceTransform::row(int32_t y, NearestRow& nearest)
{
  const auto columns = static_cast<size_t>(columns_);
  const int16_t* const along = along_.data() + static_cast<size_t>(y) * columns;
  nearest.squared.resize(columns);
  nearest.dx.resize(columns);
  nearest.dy.resize(columns);
  if (is_narrow_)
  {
    lowestOfWindow(along, columns);
  }
  else
  {
    lowestOfEnvelope(along, columns_);
  }
  decode(along, nearest);
}

void DistanceTransform::lowestOfWindow(const int16_t* along, size_t columns)
{
  const auto width = static_cast<size_t>(2 * reach_ + 1);
  int16_t* const heights = heights_.data() + reach_;
  for (size_t x = 0; x < columns; ++x)
  {
    heights[x] = static_cast<int16_t>(along[x] * along[x] << kColumnBits);
  }
  const auto none = static_cast<int16_t>((reach_ + 1) * (reach_ + 1) << kColumnBits);
  for (size_t x = 0; x < source_.size(); x += kChunk)
  {
    const int16_t* const window = heights_.data() + x;
    std::array<int16_t, kChunk> lowest{};
    lowest.fill(none);
    const int16_t least = *std::min_element(window, window + kChunk + width - 1);
    for (size_t k = 0; least < none && k < width; ++k)
    {
      const int32_t dx = static_cast<int32_t>(k) - reach_;
      const auto more = static_cast<int16_t>((dx * dx << kColumnBits) + static_cast<int32_t>(k));
      for (size_t i = 0; i < kChunk; ++i)
      {
        lowest[i] = std::min(lowest[i], static_cast<int16_t>(window[k + i] + more));
      }
    }
    for (size_t i = 0; i < kChunk; ++i)
    {
      const auto dx = static_cast<int16_t>((lowest[i] & kColumnMask) - reach_);
      source_[x + i] = (lowest[i] >> kColumnBits) <= most_squared_ ? dx : kNoSource;
    }
  }
}

void DistanceTransform::lowestOfEnvelope(const int16_t* along, int32_t columns)
{
  const auto squared = [](int64_t v) { return v * v; };
  const auto height = [&](int32_t column) { return squared(along[column]); };
  const auto value = [&](int32_t x, int32_t column)
  { return squared(int64_t{x} - column) + height(column); };
  // The last x at which the parabola at a is not higher than that at b > a.
  const auto last = [&](int32_t a, int32_t b)
  {
    return geometry::floorDiv(
        squared(b) - squared(a) + height(b) - height(a), 2 * (int64_t{b} - a));
  };
  size_t n = 0;
  for (int32_t u = 0; u < columns; ++u)
  {
    if (std::abs(along[u]) > reach_)
    {
      continue;
    }
    while (n > 0 && value(envelope_[n - 1].first, envelope_[n - 1].column) >
                        value(envelope_[n - 1].first, u))
    {
      --n;
    }
    const int64_t first = n == 0 ? 0 : last(envelope_[n - 1].column, u) + 1;
    if (first < columns)
    {
      envelope_[n++] = {u, static_cast<int32_t>(first)};
    }
  }
  int32_t end = columns;
  for (; n > 0; --n)
  {
    const auto [column, first] = envelope_[n - 1];
    for (int32_t x = first; x < end; ++x)
    {
      source_[static_cast<size_t>(x)] =
          value(x, column) <= most_squared_ ? static_cast<int16_t>(column - x) : kNoSource;
    }
    end = first;
  }
  std::fill(source_.begin(), source_.begin() + end, kNoSource);
}

void DistanceTransform::decode(const int16_t* along, NearestRow& nearest) const
{
  for (int32_t x = 0; x < columns_; ++x)
  {
    const auto i = static_cast<size_t>(x);
    const int32_t dx = source_[i];
    if (dx == kNoSource)
    {
      nearest.squared[i] = NearestRow::kNone;
      nearest.dx[i] = nearest.dy[i] = 0;
      continue;
    }
    const int32_t dy = along[x + dx];
    nearest.squared[i] = dx * dx + dy * dy;
    nearest.dx[i] = static_cast<int16_t>(dx);
    nearest.dy[i] = static_cast<int16_t>(dy);
  }
}
}  // namespace traverse::layers
