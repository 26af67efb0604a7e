// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "truth_grid.h"

#include <cstdint>
#include <vector>

namespace traverse::simulation
{
/** What a piece of an object fills above a sub-square. */
struct Interval
{
  static constexpr uint32_t kNone = 0xFFFFFFFFU;

  float lo_m = 0;
  float hi_m = 0;
  uint32_t object = Scene::kNoObject;
  uint32_t piece = 0;  //!< number of the part or ball that it belongs to
  uint32_t next = kNone;
  bool yields = false;
};

/** The intervals of every sub-square: a list each, of those that touch it. */
class Pieces
{
 public:
  explicit Pieces(const SubGrid& grid) : grid_(grid), first_(grid.size(), Interval::kNone) {}

  /** Adds a thing at its pose at at_s. Throws std::invalid_argument for a triangle of vertices that
   * are not there. */
  void add(const Object& object, uint32_t number, double at_s);

  /** Calls visit(const Interval&) for those of a sub-square, in no order that matters. */
  template <class Visit>
  void forEachAt(size_t sub, Visit&& visit) const
  {
    for (uint32_t i = first_[sub]; i != Interval::kNone; i = intervals_[i].next)
    {
      visit(intervals_[i]);
    }
  }

  bool anyAt(size_t sub) const { return first_[sub] != Interval::kNone; }

 private:
  struct Filling
  {
    uint32_t object = 0;
    uint32_t piece = 0;
    bool yields = false;
    bool solid = true;
  };

  void addPart(const Part& part, const Eigen::Isometry3d& T_map_body, Filling filling);
  void addTriangle(const std::array<Eigen::Vector3d, 3>& corners, const Filling& filling);
  void addBall(const Ball& ball, const Eigen::Isometry3d& T_map_body, const Filling& filling);
  void put(size_t sub, double lo_m, double hi_m, const Filling& filling);

  const SubGrid& grid_;
  std::vector<uint32_t> first_;
  std::vector<Interval> intervals_;
  uint32_t pieces_ = 0;
};
}  // namespace traverse::simulation
