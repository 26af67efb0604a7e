// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clusters.h"

#include <traverse/evaluation/cells.h>

namespace traverse::evaluation
{
namespace
{
class Gatherer
{
 public:
  Gatherer(const layers::LayerSet& map, uint8_t code) :
      codes_(viewOf<uint8_t>(map, map.class_layer)), code_(code), seen_(codes_.size(), false)
  {
  }

  /** The cluster of a cell; empty where it has none, or one that was given before. */
  Cluster from(geometry::CellIndex first)
  {
    Cluster cluster;
    visit(first, cluster);
    for (size_t next = 0; next < cluster.size(); ++next)
    {
      const geometry::CellIndex c = cluster[next];
      for (int32_t k = 0; k < 9; ++k)
      {
        visit({c.x + k % 3 - 1, c.y + k / 3 - 1}, cluster);
      }
    }
    return cluster;
  }

 private:
  void visit(geometry::CellIndex c, Cluster& cluster)
  {
    if (codes_.at(c) == code_ && codes_.extent().contains(c) && !seen_[codes_.indexOf(c)])
    {
      seen_[codes_.indexOf(c)] = true;
      cluster.push_back(c);
    }
  }

  CellView<uint8_t> codes_;
  uint8_t code_;
  std::vector<bool> seen_;
};
}  // namespace

std::vector<Cluster> clustersOf(const layers::LayerSet& map, uint8_t code)
{
  Gatherer gatherer(map, code);
  std::vector<Cluster> clusters;
  forEachCell(
      map.extent,
      [&](geometry::CellIndex c)
      {
        Cluster cluster = gatherer.from(c);
        if (!cluster.empty())
        {
          clusters.push_back(std::move(cluster));
        }
      });
  return clusters;
}
}  // namespace traverse::evaluation
