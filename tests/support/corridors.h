// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/exact_trig.h>
#include <traverse/layers/occupancy_state.h>
#include <traverse/layers/safety_buffer.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

// Straight corridors between two walls, and whether a safety buffer leaves a way through them.
namespace traverse::testing
{
/** A corridor whose middle line goes through a place near the grid's middle. */
struct Corridor
{
  double yaw_deg = 0;
  double width_m = 5;
  double off_m = 0;  //!< of its middle line to the left of the grid's middle
};

/** A square of cells with a corridor in it, and the buffer's verdict. */
class CorridorCheck
{
 public:
  CorridorCheck(const Corridor& corridor, const layers::BufferParams& params) :
      corridor_(corridor), cell_m_(params.cell_size_m)
  {
    const auto [s, c] = geometry::sinCosOf(corridor.yaw_deg * geometry::kPi / 180);
    sine_ = s;
    cosine_ = c;
    std::vector<uint8_t> states;
    states.reserve(size_t{kEdge} * kEdge);
    for (int32_t y = 0; y < kEdge; ++y)
    {
      for (int32_t x = 0; x < kEdge; ++x)
      {
        const double side = std::abs(left_m(x, y));
        const bool wall = side >= corridor.width_m / 2 && side < corridor.width_m / 2 + kWall_m;
        states.push_back(static_cast<uint8_t>(
            wall ? layers::OccupancyState::obstacle : layers::OccupancyState::free));
      }
    }
    zones_ = layers::safetyBuffer(states, kEdge, params);
  }

  /** Whether cells that may be planned through connect the ends, within the walls. */
  bool isConnected() const
  {
    std::vector<uint8_t> seen(zones_.size());
    std::vector<std::pair<int32_t, int32_t>> open;
    const auto visit = [&](int32_t x, int32_t y)
    {
      if (isInside(x, y) && seen[at(x, y)] == 0 && mayBePlanned(x, y))
      {
        seen[at(x, y)] = 1;
        open.emplace_back(x, y);
      }
    };
    forEach([&](int32_t x, int32_t y) { ahead_m(x, y) < -kReach_m ? visit(x, y) : void(); });
    while (!open.empty())
    {
      const auto [x, y] = open.back();
      open.pop_back();
      if (ahead_m(x, y) > kReach_m)
      {
        return true;
      }
      for (int32_t i = 0; i < 9; ++i)
      {
        visit(x + i % 3 - 1, y + i / 3 - 1);
      }
    }
    return false;
  }

  /** The farthest that a strip cell's middle is from the corridor's middle line, cells. */
  double farthestOffCentre_cells() const
  {
    double farthest = 0;
    forEach(
        [&](int32_t x, int32_t y)
        {
          if (isInside(x, y) && zone(x, y) == layers::BufferZone::strip &&
              std::abs(ahead_m(x, y)) < kReach_m)
          {
            farthest = std::max(farthest, std::abs(left_m(x, y)) / cell_m_);
          }
        });
    return farthest;
  }

 private:
  static constexpr int32_t kEdge = 160;
  static constexpr double kWall_m = 0.4;
  static constexpr double kReach_m = 10;  // to either side of the middle

  template <class F>
  static void forEach(F&& f)
  {
    for (int32_t y = 0; y < kEdge; ++y)
    {
      for (int32_t x = 0; x < kEdge; ++x)
      {
        f(x, y);
      }
    }
  }

  double dx(int32_t x) const { return (x + 0.5 - kEdge / 2.0) * cell_m_; }

  double left_m(int32_t x, int32_t y) const
  {
    return -sine_ * dx(x) + cosine_ * dx(y) - corridor_.off_m;
  }

  double ahead_m(int32_t x, int32_t y) const { return cosine_ * dx(x) + sine_ * dx(y); }

  bool isInside(int32_t x, int32_t y) const
  {
    return x >= 0 && y >= 0 && x < kEdge && y < kEdge &&
           std::abs(left_m(x, y)) < corridor_.width_m / 2 && std::abs(ahead_m(x, y)) < kReach_m + 1;
  }

  static size_t at(int32_t x, int32_t y)
  {
    return static_cast<size_t>(y) * kEdge + static_cast<size_t>(x);
  }

  layers::BufferZone zone(int32_t x, int32_t y) const
  {
    return static_cast<layers::BufferZone>(zones_.at(at(x, y)));
  }

  bool mayBePlanned(int32_t x, int32_t y) const
  {
    return zone(x, y) == layers::BufferZone::none || zone(x, y) == layers::BufferZone::strip;
  }

  Corridor corridor_;
  double cell_m_;
  double sine_ = 0;
  double cosine_ = 1;
  std::vector<uint8_t> zones_;
};
}  // namespace traverse::testing
