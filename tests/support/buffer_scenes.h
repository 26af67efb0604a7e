// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>
#include <traverse/layers/occupancy_state.h>
#include <traverse/layers/safety_buffer.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace traverse::testing
{
/** A place in cells; the middle of cell (x, y) is at (x + 0.5, y + 0.5). */
struct Place
{
  double x = 0;
  double y = 0;
};

/** Known free cells, into which things are drawn. */
class BufferScene
{
 public:
  explicit BufferScene(int32_t edge) :
      edge_(edge),
      states_(
          static_cast<size_t>(edge) * static_cast<size_t>(edge),
          static_cast<uint8_t>(layers::OccupancyState::free))
  {
  }

  int32_t edge() const { return edge_; }

  const std::vector<uint8_t>& states() const { return states_; }

  size_t index(int32_t x, int32_t y) const
  {
    return static_cast<size_t>(y) * static_cast<size_t>(edge_) + static_cast<size_t>(x);
  }

  /** An obstacle in all cells whose middle it contains: contains(Place). */
  template <class F>
  void add(F&& contains, layers::OccupancyState state = layers::OccupancyState::obstacle)
  {
    for (int32_t y = 0; y < edge_; ++y)
    {
      for (int32_t x = 0; x < edge_; ++x)
      {
        if (contains(Place{x + 0.5, y + 0.5}))
        {
          states_[index(x, y)] = static_cast<uint8_t>(state);
        }
      }
    }
  }

  std::vector<uint8_t> buffer(const layers::BufferParams& params) const
  {
    return layers::safetyBuffer(states_, edge_, params);
  }

 private:
  int32_t edge_;
  std::vector<uint8_t> states_;
};

/** Two walls along a line through a place, in its direction. */
struct Corridor
{
  Place middle;
  double angle_deg = 0;
  double width = 20;     // cells between the walls
  double length = 120;   // cells
  double thickness = 3;  // of a wall, cells

  /** Along the corridor and to its left, from the middle. */
  Place along(Place p) const
  {
    const geometry::SinCos turn = geometry::sinCosOf(angle_deg * geometry::kPi / 180);
    const Place d = {p.x - middle.x, p.y - middle.y};
    return {d.x * turn.cos + d.y * turn.sin, d.y * turn.cos - d.x * turn.sin};
  }

  bool isWall(Place p) const
  {
    const Place q = along(p);
    return std::abs(q.x) <= length / 2 && std::abs(q.y) > width / 2 &&
           std::abs(q.y) <= width / 2 + thickness;
  }
};

inline const std::vector<std::pair<int32_t, int32_t>> kSideSteps = {
    {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
inline const std::vector<std::pair<int32_t, int32_t>> kAllSteps = {
    {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

/** Parts of a grid in which one can go from cell to cell. */
class Reach
{
 public:
  /** Marks cells reached from (x, y) over those that are passable, by 4 or 8 neighbours. */
  Reach(const std::vector<bool>& passable, int32_t edge, size_t start, int neighbours) :
      reached_(passable.size())
  {
    std::vector<size_t> open;
    auto visit = [&](size_t cell)
    {
      if (passable[cell] && !reached_[cell])
      {
        reached_[cell] = true;
        open.push_back(cell);
      }
    };
    visit(start);
    while (!open.empty())
    {
      const size_t cell = open.back();
      open.pop_back();
      const auto x = static_cast<int32_t>(cell % static_cast<size_t>(edge));
      const auto y = static_cast<int32_t>(cell / static_cast<size_t>(edge));
      for (const auto& [dx, dy] : neighbours == 8 ? kAllSteps : kSideSteps)
      {
        if (x + dx >= 0 && x + dx < edge && y + dy >= 0 && y + dy < edge)
        {
          const int32_t next = (y + dy) * edge + x + dx;
          visit(static_cast<size_t>(next));
        }
      }
    }
  }

  bool has(size_t cell) const { return reached_[cell]; }

 private:
  std::vector<bool> reached_;
};
}  // namespace traverse::testing
