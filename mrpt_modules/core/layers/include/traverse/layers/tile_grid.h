// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_map>
#include <vector>

namespace traverse::layers
{
/** Cells in square tiles that are made where they are needed, found by hash. A cell costs the same
 * to reach whatever the size of the map, and cell indices are absolute (geometry/lattice.h).
 *
 * `Cell` is a small value; Cell{} is an empty cell. */
template <class Cell>
class TileGrid
{
 public:
  static constexpr int32_t kSide = 32;  //!< cells along a tile's edge
  static constexpr size_t kTileBytes = sizeof(Cell) * kSide * kSide;

  /** Where a cell is stored, until its tile is released. */
  struct Place
  {
    uint32_t tile = 0;
    uint32_t offset = 0;
  };

  /** Makes the cell's tile where it is missing; nothing where there are most_tiles already. */
  std::optional<Place> obtain(geometry::CellIndex cell, size_t most_tiles)
  {
    const geometry::CellIndex tile = tileOf(cell);
    Recent& recent = recent_
        [static_cast<size_t>(tile.y & kRecentMask) * kRecentSide +
         static_cast<size_t>(tile.x & kRecentMask)];
    if (!recent.known || !(recent.position == tile))
    {
      const std::optional<uint32_t> number = obtainTile(tile, most_tiles);
      if (!number)
      {
        return std::nullopt;
      }
      recent = {tile, *number, true};
    }
    return Place{recent.number, offsetOf(cell)};
  }

  std::optional<Place> find(geometry::CellIndex cell) const
  {
    const auto found = directory_.find(tileOf(cell));
    return found == directory_.end() ? std::nullopt
                                     : std::optional(Place{found->second, offsetOf(cell)});
  }

  Cell& at(Place place) { return tiles_[place.tile].cells[place.offset]; }

  const Cell& at(Place place) const { return tiles_[place.tile].cells[place.offset]; }

  /** nullptr where the cell's tile was never made. */
  const Cell* get(geometry::CellIndex cell) const
  {
    const std::optional<Place> place = find(cell);
    return place ? &at(*place) : nullptr;
  }

  geometry::CellIndex indexOf(Place place) const
  {
    const geometry::CellIndex tile = tiles_[place.tile].position;
    const auto offset = static_cast<int32_t>(place.offset);
    return {tile.x * kSide + offset % kSide, tile.y * kSide + offset / kSide};
  }

  /** Calls f(Place) for every cell of `window` in a tile that was made: tiles by y, then x, and
   * within a tile cells by y, then x. Costs by the tiles there, not by the window. */
  template <class F>
  void forEachIn(const geometry::CellRect& window, F&& f) const
  {
    for (const uint32_t tile : tilesIn(window))
    {
      const geometry::CellRect part = geometry::intersection(rectOf(tiles_[tile].position), window);
      for (int32_t y = part.min.y; y < part.max.y; ++y)
      {
        for (int32_t x = part.min.x; x < part.max.x; ++x)
        {
          f(Place{tile, offsetOf({x, y})});
        }
      }
    }
  }

  /** The same for all cells. */
  template <class F>
  void forEach(F&& f) const
  {
    for (const uint32_t tile : sorted())
    {
      for (uint32_t offset = 0; offset < static_cast<uint32_t>(kSide * kSide); ++offset)
      {
        f(Place{tile, offset});
      }
    }
  }

  /** Forgets the tiles that meet `window` and lie wholly outside `kept`. */
  void releaseTiles(const geometry::CellRect& window, const geometry::CellRect& kept)
  {
    for (const uint32_t number : tilesIn(window))
    {
      Tile& tile = tiles_[number];
      if (geometry::intersection(rectOf(tile.position), kept).empty())
      {
        directory_.erase(tile.position);
        tile.cells.fill(Cell{});
        free_.push_back(number);
      }
    }
    recent_.fill({});
  }

  void clear() { *this = TileGrid(); }

  size_t tiles() const { return directory_.size(); }

 private:
  static constexpr int32_t kShift = 5;
  static_assert(1 << kShift == kSide);
  // Recently used tiles, by the low bits of their position: a window of up to 32 x 32 tiles (204 m
  // of 0.2 m cells) never meets the hash table twice for one tile.
  static constexpr int32_t kRecentSide = 32;
  static constexpr int32_t kRecentMask = kRecentSide - 1;

  struct Tile
  {
    geometry::CellIndex position;
    std::array<Cell, static_cast<size_t>(kSide) * kSide> cells{};
  };

  struct Recent
  {
    geometry::CellIndex position;
    uint32_t number = 0;
    bool known = false;
  };

  struct Hash
  {
    size_t operator()(geometry::CellIndex c) const
    {
      uint64_t h = (uint64_t{static_cast<uint32_t>(c.y)} << 32U) | static_cast<uint32_t>(c.x);
      h *= 0x9E3779B97F4A7C15U;
      return h ^ (h >> 32U);
    }
  };

  static geometry::CellIndex tileOf(geometry::CellIndex cell)
  {
    return {cell.x >> kShift, cell.y >> kShift};
  }

  static uint32_t offsetOf(geometry::CellIndex cell)
  {
    return static_cast<uint32_t>((cell.y & (kSide - 1)) * kSide + (cell.x & (kSide - 1)));
  }

  static geometry::CellRect rectOf(geometry::CellIndex tile)
  {
    return {{tile.x * kSide, tile.y * kSide}, {tile.x * kSide + kSide, tile.y * kSide + kSide}};
  }

  std::optional<uint32_t> obtainTile(geometry::CellIndex position, size_t most_tiles)
  {
    if (const auto found = directory_.find(position); found != directory_.end())
    {
      return found->second;
    }
    if (directory_.size() >= most_tiles)
    {
      return std::nullopt;
    }
    if (free_.empty())
    {
      free_.push_back(static_cast<uint32_t>(tiles_.size()));
      tiles_.emplace_back();
    }
    const uint32_t number = free_.back();
    free_.pop_back();
    tiles_[number].position = position;
    directory_.emplace(position, number);
    return number;
  }

  void sortByPosition(std::vector<uint32_t>& numbers) const
  {
    std::sort(
        numbers.begin(), numbers.end(),
        [this](uint32_t a, uint32_t b)
        {
          const geometry::CellIndex p = tiles_[a].position;
          const geometry::CellIndex q = tiles_[b].position;
          return p.y != q.y ? p.y < q.y : p.x < q.x;
        });
  }

  std::vector<uint32_t> sorted() const
  {
    std::vector<uint32_t> numbers;
    numbers.reserve(directory_.size());
    for (const auto& [position, number] : directory_)
    {
      numbers.push_back(number);
    }
    sortByPosition(numbers);
    return numbers;
  }

  /** Numbers of the tiles that meet the window, sorted. */
  std::vector<uint32_t> tilesIn(const geometry::CellRect& window) const
  {
    std::vector<uint32_t> numbers;
    if (window.empty())
    {
      return numbers;
    }
    const geometry::CellIndex first = tileOf(window.min);
    const geometry::CellIndex last = tileOf({window.max.x - 1, window.max.y - 1});
    const auto columns = static_cast<uint64_t>(int64_t{last.x} - first.x + 1);
    const auto rows = static_cast<uint64_t>(int64_t{last.y} - first.y + 1);
    if (columns * rows > directory_.size())
    {
      numbers = sorted();
      std::erase_if(
          numbers, [&](uint32_t n)
          { return geometry::intersection(rectOf(tiles_[n].position), window).empty(); });
      return numbers;
    }
    for (int32_t y = first.y; y <= last.y; ++y)
    {
      for (int32_t x = first.x; x <= last.x; ++x)
      {
        if (const auto found = directory_.find({x, y}); found != directory_.end())
        {
          numbers.push_back(found->second);
        }
      }
    }
    return numbers;
  }

  std::deque<Tile> tiles_;  // growing never moves a tile
  std::vector<uint32_t> free_;
  std::unordered_map<geometry::CellIndex, uint32_t, Hash> directory_;
  std::array<Recent, static_cast<size_t>(kRecentSide) * kRecentSide> recent_{};
};
}  // namespace traverse::layers
