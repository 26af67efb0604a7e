// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/options/option.h>

namespace traverse::formats
{
/** Section octomapOpts of every map that keeps an octree beside its cells. */
struct OctomapParams
{
  double resolution_m = 0;
  int max_memory_mb = 1000;

  friend bool operator==(const OctomapParams&, const OctomapParams&) = default;
};

template <class P, class F>
void visitOctomapParams(P& p, F&& f)
{
  using options::Option;
  f(
      Option{
          "resolution_m",
          "edge of the leaves of an octree of all points, saved as .bt and .ot, m, to 1 mm, not "
          "above the map's cell size; 0 = no octree",
          {0, 10}},
      p.resolution_m);
  f(
      Option{
          "max_memory_mb",
          "the octree takes no more, MB; points that would need more are counted, not added",
          {1, 1000000}},
      p.max_memory_mb);
}

template <class F>
void visit(OctomapParams& p, F&& f)
{
  visitOctomapParams(p, f);
}

template <class F>
void visit(const OctomapParams& p, F&& f)
{
  visitOctomapParams(p, f);
}

/** Throws OptionError where a member is out of its range, or the resolution is no whole number of
 * millimetres, or above 0 and below 5 mm (a map would end 164 m from its zero), or coarser than
 * the cells of its map. */
void check(const OctomapParams& params, double cell_size_m);
}  // namespace traverse::formats
