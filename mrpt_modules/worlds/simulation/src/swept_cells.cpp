// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_grid.h"
#include "truth_limits.h"

#include <traverse/simulation/footprints.h>

#include <algorithm>
#include <cmath>

namespace traverse::simulation
{
namespace
{
/** A thing's hull seen from above, and how far it reaches from its frame's origin. */
struct Body
{
  std::vector<Eigen::Vector3d> points;
  double reach_m = 0;
};

Body bodyOf(const Object& object)
{
  Body body;
  const auto add = [&](const Eigen::Vector3d& p)
  {
    if (!p.allFinite())
    {
      return;
    }
    body.points.push_back(p);
    body.reach_m = std::max(body.reach_m, p.norm());
  };
  for (const Part& part : object.parts)
  {
    std::for_each(
        part.vertices.begin(), part.vertices.end(),
        [&](const Eigen::Vector3f& v) { add(v.cast<double>()); });
  }
  for (const Ball& ball : object.balls)
  {
    const Eigen::Vector3d centre = ball.centre.cast<double>();
    const double r = ball.radius_m;
    for (const auto& [dx, dy] : {std::pair{-r, -r}, {-r, r}, {r, -r}, {r, r}})
    {
      add(centre + Eigen::Vector3d(dx, dy, 0));
    }
  }
  return body;
}

/** The larger of how far a convex outline keeps clear of a square beside each of its edges; the
 * square touches where none is above 0 (the square's own sides are the caller's). */
bool touches(const Outline& outline, const Eigen::Vector2d& centre, double half_m)
{
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const Eigen::Vector2d& from = outline[i];
    const Eigen::Vector2d edge = outline[(i + 1) % outline.size()] - from;
    const double inside = edge.x() * (centre.y() - from.y()) - edge.y() * (centre.x() - from.x());
    if (inside < -half_m * (std::abs(edge.x()) + std::abs(edge.y())))
    {
      return false;
    }
  }
  return true;
}

class Sweep
{
 public:
  explicit Sweep(const SubGrid& grid) :
      grid_(grid),
      cells_(
          static_cast<size_t>(grid.extent.width()) * static_cast<size_t>(grid.extent.height()), 0)
  {
  }

  void mark(const Body& body, const Eigen::Isometry3d& T_map_body)
  {
    std::vector<Eigen::Vector2d> seen;
    seen.reserve(body.points.size());
    for (const Eigen::Vector3d& p : body.points)
    {
      seen.emplace_back((T_map_body * p).head<2>());
    }
    const Outline outline = geometry::convexHull(std::move(seen));
    if (outline.empty())
    {
      return;
    }
    Eigen::Vector2d low = outline[0];
    Eigen::Vector2d high = outline[0];
    for (const Eigen::Vector2d& p : outline)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const int32_t width = grid_.extent.width();
    const int32_t height = grid_.extent.height();
    for (int32_t y = cell(low.y() - grid_.minY_m(), height);
         y <= last(high.y() - grid_.minY_m(), height); ++y)
    {
      for (int32_t x = cell(low.x() - grid_.minX_m(), width);
           x <= last(high.x() - grid_.minX_m(), width); ++x)
      {
        const Eigen::Vector2d centre(
            grid_.lattice.centre_m(grid_.extent.min.x + x),
            grid_.lattice.centre_m(grid_.extent.min.y + y));
        if (touches(outline, centre, grid_.lattice.cell_m() / 2))
        {
          cells_[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] = 1;
        }
      }
    }
  }

  std::vector<uint8_t> take() { return std::move(cells_); }

 private:
  int32_t cell(double from_edge_m, int32_t count) const
  {
    const double index = std::floor(from_edge_m / grid_.lattice.cell_m());
    return static_cast<int32_t>(std::clamp(index, 0.0, static_cast<double>(count)));
  }

  int32_t last(double from_edge_m, int32_t count) const
  {
    const double index = std::floor(from_edge_m / grid_.lattice.cell_m());
    return static_cast<int32_t>(std::clamp(index, -1.0, count - 1.0));
  }

  const SubGrid& grid_;
  std::vector<uint8_t> cells_;
};

/** Times of [from_s, to_s] between which no point of the body moves farther than step_m. */
std::vector<double> timesOf(
    const Motion& motion, double reach_m, double step_m, const std::pair<double, double>& window)
{
  std::vector<double> stops = {window.first};
  for (const TimedPose& pose : motion.poses())
  {
    if (pose.t_s > window.first && pose.t_s < window.second)
    {
      stops.push_back(pose.t_s);
    }
  }
  stops.push_back(window.second);
  std::vector<double> times;
  for (size_t i = 0; i + 1 < stops.size(); ++i)
  {
    constexpr double kArcPerChord = 1.6;  // pi / 2, for turns of up to half a circle
    constexpr double kMostSteps = 1e5;
    const Eigen::Isometry3d a = motion.at(stops[i]);
    const Eigen::Isometry3d b = motion.at(stops[i + 1]);
    const double way_m =
        (a.translation() - b.translation()).norm() + reach_m * (a.linear() - b.linear()).norm();
    const int steps =
        static_cast<int>(std::clamp(std::ceil(kArcPerChord * way_m / step_m), 1.0, kMostSteps));
    for (int k = 0; k < steps; ++k)
    {
      times.push_back(stops[i] + (stops[i + 1] - stops[i]) * k / steps);
    }
  }
  times.push_back(window.second);
  return times;
}
}  // namespace

layers::LayerSet sweptCells(
    const Scene& scene, const TruthParams& params, double from_s, double to_s)
{
  const SubGrid grid = subGridOf(scene.area, checkedCell_mm(params));
  Sweep sweep(grid);
  for (const Object& object : scene.objects)
  {
    if (!object.motion.moves())
    {
      continue;
    }
    const Body body = bodyOf(object);
    for (const double t_s :
         timesOf(object.motion, body.reach_m, grid.lattice.cell_m() / 2, {from_s, to_s}))
    {
      sweep.mark(body, object.motion.at(t_s));
    }
  }
  layers::LayerSet set;
  set.lattice = grid.lattice;
  set.extent = grid.extent;
  set.layers.push_back({"truth_swept", "1", sweep.take()});
  return set;
}
}  // namespace traverse::simulation
