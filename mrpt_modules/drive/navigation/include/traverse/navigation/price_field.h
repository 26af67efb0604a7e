// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/terrain.h>

#include <cstdint>
#include <span>
#include <vector>

namespace traverse::navigation
{
/** What the way from each cell to the nearest of some cells costs: sum of metres times price over
 * the 8 neighbours (Dijkstra). From a cell to a neighbour half of the way is paid at the price of
 * one and half at that of the other; diagonal ones are reached only between two open cells.
 *
 * Grown only as far as is asked for. No cell is nearer to another than the cheapest step, so a
 * queue of buckets as wide as that step needs no order within a bucket (Denardo and Fox 1979). */
class PriceField
{
 public:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /** A cell from which the field grows, and what lies beyond it. */
  struct Seed
  {
    size_t index = 0;  //!< of Terrain; open
    double price = 0;  //!< finite, >= 0
  };

  /** Forgets all; the terrain must live as long as the field is used. */
  void start(const Terrain& terrain, std::span<const Seed> seeds);

  /** Grows until the cell's price is known; kNever where no way leads. */
  double priceFrom(size_t index)
  {
    while (price_[index] >= settled_below_ && grow())
    {
    }
    return price_[index];
  }

  /** The neighbour to go to from a cell whose price is known and not kNever; itself at a seed. */
  size_t next(size_t index) const;

 private:
  struct Neighbour
  {
    ptrdiff_t offset = 0;
    double half_m = 0;         // half of the way there
    ptrdiff_t beside[2] = {};  // of diagonal ones: the cells on both sides
  };

  bool grow();
  void put(size_t index, double price);

  const Terrain* terrain_ = nullptr;
  std::vector<double> price_;
  std::vector<uint8_t> is_settled_;
  std::vector<std::vector<uint32_t>> buckets_;
  std::vector<Neighbour> neighbours_;
  double bucket_width_ = 1;
  double lowest_ = 0;  // of the seeds
  double settled_below_ = 0;
  int64_t bucket_ = 0;
  size_t waiting_ = 0;
};
}  // namespace traverse::navigation
