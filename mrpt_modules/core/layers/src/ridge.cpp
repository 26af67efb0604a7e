// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ridge.h"

#include <traverse/layers/occupancy_state.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace traverse::layers
{
namespace
{
constexpr auto kSoft = static_cast<uint8_t>(BufferZone::soft);
constexpr auto kStrip = static_cast<uint8_t>(BufferZone::strip);
constexpr uint8_t kPerhaps = 255;  // soft, and may become strip

// Distances along the middle of a corridor go up and down by so much, as its walls fall on cells.
constexpr float kSlack_cells = 1;

/** Obstacles are about as far away: a strip is not joined to the dents of its walls. */
bool areAlike(float a, float b)
{
  return std::min(a, b) >= 0.7F * std::max(a, b);
}

/** Which strips are one. */
class Joined
{
 public:
  explicit Joined(size_t labels) : parent_(labels)
  {
    std::iota(parent_.begin(), parent_.end(), uint32_t{0});
  }

  uint32_t find(uint32_t label)
  {
    while (parent_[label] != label)
    {
      label = parent_[label] = parent_[parent_[label]];
    }
    return label;
  }

  /** False where they were before. */
  bool join(uint32_t a, uint32_t b)
  {
    const uint32_t root = find(a);
    const bool is_new = root != find(b);
    parent_[root] = find(b);
    return is_new;
  }

 private:
  std::vector<uint32_t> parent_;
};
}  // namespace

void Ridge::add(size_t cell, int32_t squared_distance, bool is_strip)
{
  uint8_t& zone = buffer_.zones[cell];
  if (zone == kSoft)
  {
    index_[cell] = static_cast<uint32_t>(cells_.size());
    cells_.push_back({cell, std::sqrt(static_cast<float>(squared_distance))});
    zone = kPerhaps;
  }
  if (zone == kPerhaps && is_strip)
  {
    zone = kStrip;
    cells_[index_[cell]].is_seed = true;
  }
}

/** The way by which a search came becomes strip. */
void Ridge::cutBackFrom(size_t at)
{
  for (; buffer_.zones[cells_[at].cell] == kPerhaps; at = cells_[at].from)
  {
    buffer_.zones[cells_[at].cell] = kStrip;
  }
}

std::vector<size_t> Ridge::strips() const
{
  std::vector<size_t> found;
  for (size_t i = 0; i < cells_.size(); ++i)
  {
    if (buffer_.zones[cells_[i].cell] == kStrip)
    {
      found.push_back(i);
    }
  }
  return found;
}

/** Ragged walls have gaps in a strip: from all strips at once, over what may be ridge, as far as
 * the obstacles are away there; where two searches meet, they become one strip. */
void Ridge::joinStrips(uint32_t labels)
{
  Joined joined(labels);
  std::vector<size_t> open = strips();
  std::vector<float> steps(cells_.size());
  std::vector<float> distances(cells_.size());  // where the way began
  for (const size_t i : open)
  {
    distances[i] = cells_[i].distance;
  }
  for (size_t next = 0; next < open.size(); ++next)
  {
    const size_t here = open[next];
    const auto meet = [&](size_t cell)
    {
      const size_t there = index_[cell];
      const bool is_far = steps[here] + 1 > cells_[here].distance;
      if (cells_[there].label == 0 && !is_far)
      {
        cells_[there].label = cells_[here].label;
        cells_[there].from = here;
        steps[there] = steps[here] + 1;
        distances[there] = distances[here];
        open.push_back(there);
      }
      else if (
          cells_[there].label != 0 && areAlike(distances[here], distances[there]) &&
          joined.join(cells_[here].label, cells_[there].label))
      {
        cutBackFrom(here);
        cutBackFrom(there);
      }
    };
    buffer_.forEachNeighbour(
        cells_[here].cell,
        [&](size_t cell)
        {
          if (buffer_.zones[cell] == kPerhaps || buffer_.zones[cell] == kStrip)
          {
            meet(cell);
          }
        });
  }
}

/** From the strips over what may be ridge, as long as it recedes from obstacles; where that ends in
 * the open, the way is strip. */
void Ridge::leadOut()
{
  std::vector<size_t> open = strips();
  for (const size_t i : open)
  {
    cells_[i].farthest = cells_[i].distance;
  }
  for (size_t next = 0; next < open.size(); ++next)
  {
    const size_t here = open[next];
    if (buffer_.isBesideFree(cells_[here].cell))
    {
      cutBackFrom(here);
      continue;
    }
    buffer_.forEachNeighbour(
        cells_[here].cell,
        [&](size_t cell)
        {
          const size_t there = buffer_.zones[cell] == kPerhaps ? index_[cell] : here;
          const float farthest = cells_[here].farthest;
          if (cells_[there].farthest == 0 && cells_[there].distance >= farthest - kSlack_cells)
          {
            cells_[there].farthest = std::max(farthest, cells_[there].distance);
            cells_[there].from = here;
            open.push_back(there);
          }
        });
  }
}

void Ridge::finish()
{
  joinStrips(labelStrips());
  leadOut();
  for (const Cell& ridge : cells_)
  {
    uint8_t& zone = buffer_.zones[ridge.cell];
    zone = zone == kPerhaps ? kSoft : zone;
  }
  dropDents(labelStrips());
}
}  // namespace traverse::layers
