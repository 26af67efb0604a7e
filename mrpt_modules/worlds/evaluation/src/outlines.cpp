// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clusters.h"
#include "polygons.h"

#include <traverse/evaluation/cells.h>
#include <traverse/evaluation/obstacles.h>
#include <traverse/evaluation/outlines.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::evaluation
{
namespace
{
constexpr double kFar = std::numeric_limits<double>::infinity();

uint64_t cornersOf(const TrueOutline& outline)
{
  uint64_t corners = 0;
  for (const Polygon& polygon : outline.polygons)
  {
    corners += polygon.size();
  }
  return corners;
}

class Matching
{
 public:
  Matching(const layers::LayerSet& map, const std::vector<TrueOutline>& outlines) :
      lattice_(map.lattice), outlines_(outlines), cells_of_(outlines.size())
  {
    boxes_.reserve(outlines.size());
    std::transform(
        outlines.begin(), outlines.end(), std::back_inserter(boxes_),
        [](const TrueOutline& outline) { return boxOf(outline); });
  }

  /** False where the cluster touches no thing. */
  bool add(const Cluster& cluster)
  {
    std::vector<size_t> touched;
    for (size_t i = 0; i < outlines_.size(); ++i)
    {
      const bool near = std::any_of(
          cluster.begin(), cluster.end(),
          [&](geometry::CellIndex c) { return distance(i, c, reach_m()) <= reach_m(); });
      if (near)
      {
        touched.push_back(i);
      }
    }
    for (const geometry::CellIndex c : touched.empty() ? Cluster{} : cluster)
    {
      size_t nearest = touched[0];
      double least = kFar;
      for (const size_t i : touched)
      {
        const double d = distance(i, c, least);
        nearest = d < least ? i : nearest;
        least = std::min(least, d);
      }
      cells_of_[nearest].push_back(c);
    }
    return !touched.empty();
  }

  OutlineScores take()
  {
    OutlineScores scores;
    for (size_t i = 0; i < outlines_.size(); ++i)
    {
      if (cells_of_[i].empty())
      {
        scores.not_found.push_back(outlines_[i].object);
      }
      else
      {
        scores.things.push_back(scoreOf(outlines_[i], cells_of_[i]));
      }
    }
    return scores;
  }

 private:
  /** One cell beyond the cell that holds the edge: from middle to edge. */
  double reach_m() const { return 1.5 * lattice_.cell_m(); }

  Eigen::Vector2d middle(geometry::CellIndex c) const
  {
    return {lattice_.centre_m(c.x), lattice_.centre_m(c.y)};
  }

  double distance(size_t i, geometry::CellIndex c, double if_below)
  {
    return boxes_[i].distanceTo(middle(c)) > if_below ? kFar : distanceTo(outlines_[i], c);
  }

  double distanceTo(const TrueOutline& outline, geometry::CellIndex c)
  {
    work_.spend(cornersOf(outline));
    return distanceToAny(outline, middle(c));
  }

  OutlineScore scoreOf(const TrueOutline& outline, const std::vector<geometry::CellIndex>& cells)
  {
    const double cell_m2 = lattice_.cell_m() * lattice_.cell_m();
    OutlineScore score;
    score.object = outline.object;
    const double true_cells = cellsWithin(outline);
    double both = 0;
    for (const geometry::CellIndex c : cells)
    {
      const double d = distanceTo(outline, c);
      both += d == 0 ? 1 : 0;
      score.hausdorff_m = std::max(score.hausdorff_m, d);
    }
    forEachEdgePlace(
        outline, lattice_.cell_m() / 2,
        [&](const Eigen::Vector2d& place)
        {
          work_.spend(cells.size());
          score.hausdorff_m = std::max(score.hausdorff_m, nearestOf(cells, place));
        });
    // pieces may overlap: then cells tell the area of all together
    score.true_area_m2 = outline.polygons.size() == 1 ? areaOf(outline) : true_cells * cell_m2;
    const auto found = static_cast<double>(cells.size());
    score.found_area_m2 = found * cell_m2;
    score.area_error_m2 = (found - both + true_cells - both) * cell_m2;
    return score;
  }

  /** Of a place from the nearest of the squares of cells. */
  double nearestOf(
      const std::vector<geometry::CellIndex>& cells, const Eigen::Vector2d& place) const
  {
    double least = kFar;
    for (const geometry::CellIndex c : cells)
    {
      const Eigen::Vector2d off =
          ((place - middle(c)).cwiseAbs() - Eigen::Vector2d::Constant(lattice_.cell_m() / 2))
              .cwiseMax(0.0);
      least = std::min(least, off.squaredNorm());
    }
    return std::sqrt(least);
  }

  /** Cells of which the middle lies within. */
  double cellsWithin(const TrueOutline& outline)
  {
    constexpr double kMostCells = 4e6;  // of larger ones nobody looks at each
    const Box box = boxOf(outline);
    const double cell_m2 = lattice_.cell_m() * lattice_.cell_m();
    const Eigen::Vector2d edges = (box.max - box.min).array() + lattice_.cell_m();
    if (!(edges.prod() <= kMostCells * cell_m2))
    {
      return areaOf(outline) / cell_m2;
    }
    const auto index = [&](const Eigen::Vector2d& p)
    { return lattice_.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y())); };
    const geometry::CellIndex last = index(box.max);
    double count = 0;
    forEachCell(
        {index(box.min), {last.x + 1, last.y + 1}},
        [&](geometry::CellIndex c) { count += distanceTo(outline, c) == 0 ? 1 : 0; });
    return count;
  }

  geometry::Lattice lattice_;
  const std::vector<TrueOutline>& outlines_;
  std::vector<Box> boxes_;
  std::vector<std::vector<geometry::CellIndex>> cells_of_;
  Work work_{"outlines that are too large, too detailed or too many"};  // cells x corners, x places
};

std::vector<TrueOutline> usable(const std::vector<TrueOutline>& outlines)
{
  std::vector<TrueOutline> all;
  for (TrueOutline outline : outlines)
  {
    std::erase_if(outline.polygons, [](const Polygon& p) { return !isUsable(p); });
    if (!outline.polygons.empty())
    {
      all.push_back(std::move(outline));
    }
  }
  return all;
}
}  // namespace

OutlineScores outlineScores(const layers::LayerSet& map, const std::vector<TrueOutline>& outlines)
{
  const std::vector<TrueOutline> drawn = usable(outlines);
  Matching matching(map, drawn);
  uint64_t clusters = 0;
  uint64_t foreign = 0;
  for (const Cluster& cluster : clustersOf(map, kObstacle))
  {
    ++clusters;
    foreign += matching.add(cluster) ? 0 : 1;
  }
  OutlineScores scores = matching.take();
  scores.clusters = clusters;
  scores.foreign_clusters = foreign;
  return scores;
}
}  // namespace traverse::evaluation
