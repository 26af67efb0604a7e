// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/price_field.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
void PriceField::start(const Terrain& terrain, std::span<const Seed> seeds)
{
  terrain_ = &terrain;
  price_.assign(terrain.size(), kNever);
  is_settled_.assign(terrain.size(), 0);
  const double cell_m = terrain.lattice().cell_m();
  const auto row = static_cast<ptrdiff_t>(terrain.stride());
  const double straight_m = cell_m / 2;
  const double diagonal_m = cell_m * std::sqrt(2.0) / 2;
  neighbours_ = {
      {-row, straight_m, {}},
      {-1, straight_m, {}},
      {1, straight_m, {}},
      {row, straight_m, {}},
      {-row - 1, diagonal_m, {-row, -1}},
      {-row + 1, diagonal_m, {-row, 1}},
      {row - 1, diagonal_m, {row, -1}},
      {row + 1, diagonal_m, {row, 1}}};
  lowest_ = kNever;
  double highest = 0;
  for (const Seed& seed : seeds)
  {
    lowest_ = std::min(lowest_, seed.price);
    highest = std::max(highest, seed.price);
  }
  // A little less than the cheapest step, so that rounding puts no step into its own bucket; for
  // prices that lie far apart fewer, wider ones, in which cells may be settled more than once.
  constexpr double kMostBuckets = 100000;
  const double reach =
      std::max(2 * diagonal_m * double{terrain.highest()}, seeds.empty() ? 0.0 : highest - lowest_);
  bucket_width_ = std::max(cell_m * double{kLeastPrice} * 0.999, reach / kMostBuckets);
  for (std::vector<uint32_t>& bucket : buckets_)
  {
    bucket.clear();
  }
  buckets_.resize(static_cast<size_t>(reach / bucket_width_) + 3);
  bucket_ = 0;
  waiting_ = 0;
  settled_below_ = lowest_;  // kNever without seeds
  for (const Seed& seed : seeds)
  {
    put(seed.index, seed.price);
  }
}

void PriceField::put(size_t index, double price)
{
  if (price < price_[index])
  {
    price_[index] = price;
    is_settled_[index] = 0;
    const auto bucket = static_cast<int64_t>((price - lowest_) / bucket_width_);
    buckets_[static_cast<size_t>(std::max(bucket, bucket_)) % buckets_.size()].push_back(
        static_cast<uint32_t>(index));
    ++waiting_;
  }
}

bool PriceField::grow()
{
  if (waiting_ == 0)
  {
    settled_below_ = kNever;
    return false;
  }
  std::vector<uint32_t>& bucket = buckets_[static_cast<size_t>(bucket_) % buckets_.size()];
  for (size_t k = 0; k < bucket.size(); ++k)  // it may grow meanwhile
  {
    const size_t index = bucket[k];
    --waiting_;
    if (is_settled_[index] != 0)
    {
      continue;
    }
    is_settled_[index] = 1;
    const double here = terrain_->price(index);
    for (const Neighbour& n : neighbours_)
    {
      const size_t other = index + static_cast<size_t>(n.offset);
      if (terrain_->isOpen(other) && terrain_->isOpen(index + static_cast<size_t>(n.beside[0])) &&
          terrain_->isOpen(index + static_cast<size_t>(n.beside[1])))
      {
        put(other, price_[index] + n.half_m * (here + terrain_->price(other)));
      }
    }
  }
  bucket.clear();
  ++bucket_;
  settled_below_ = lowest_ + static_cast<double>(bucket_) * bucket_width_;
  return true;
}

size_t PriceField::next(size_t index) const
{
  const double here = terrain_->price(index);
  double best = kNever;
  size_t found = index;
  for (const Neighbour& n : neighbours_)
  {
    const size_t other = index + static_cast<size_t>(n.offset);
    const double price = price_[other] + n.half_m * (here + terrain_->price(other));
    if (price < best && price_[other] < price_[index] &&
        terrain_->isOpen(index + static_cast<size_t>(n.beside[0])) &&
        terrain_->isOpen(index + static_cast<size_t>(n.beside[1])))
    {
      best = price;
      found = other;
    }
  }
  return best > price_[index] ? index : found;  // a seed's price comes from no neighbour
}
}  // namespace traverse::navigation
