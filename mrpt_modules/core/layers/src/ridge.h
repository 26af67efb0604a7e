// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "buffer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace traverse::layers
{
/** The soft cells between two obstacles: those that are strip, and those that may become so. While
 * cells are added their zones have codes of its own. */
class Ridge
{
 public:
  explicit Ridge(const Buffer& buffer) : buffer_(buffer), index_(new uint32_t[buffer.zones.size()])
  {
  }

  /** Nothing happens to cells that are not soft. */
  void add(size_t cell, int32_t squared_distance, bool is_strip);

  /** Joins strips over gaps, leads them on into the open, takes back those that are no way, and
   * makes the zones codes of BufferZone. */
  void finish();

 private:
  struct Cell
  {
    size_t cell;
    float distance;
    size_t from = 0;       // the one before on the way here
    float farthest = 0;    // distance on that way; 0: none
    uint32_t label = 0;    // of its strip, from 1
    bool is_seed = false;  // strip by itself
  };

  uint32_t labelStrips();
  void label(size_t seed, uint32_t label);
  void joinStrips(uint32_t labels);
  void leadOut();
  bool isWay(std::span<const size_t> strip) const;
  void dropDents(uint32_t labels);
  void cutBackFrom(size_t at);
  std::vector<size_t> strips() const;

  Buffer buffer_;
  std::vector<Cell> cells_;
  std::unique_ptr<uint32_t[]> index_;  // in cells_, of those in it; others' memory is not touched
};
}  // namespace traverse::layers
