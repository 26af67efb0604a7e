// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clip.h"

#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/footprints.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace traverse::simulation
{
namespace
{
bool within(const Outline& inner, const Outline& outer)
{
  constexpr double kSlack = 1e-9;  // m^2
  for (size_t i = 0; i < outer.size(); ++i)
  {
    const Eigen::Vector2d& from = outer[i];
    const Eigen::Vector2d& to = outer[(i + 1) % outer.size()];
    if (std::any_of(
            inner.begin(), inner.end(),
            [&](const Eigen::Vector2d& p) { return geometry::turnOf(from, to, p) < -kSlack; }))
    {
      return false;
    }
  }
  return true;
}

/** What of a thing stands between the ground and the vehicle's height over it. */
class Standing
{
 public:
  Standing(const Terrain& terrain, double vehicle_height_m) :
      terrain_(terrain), vehicle_height_m_(vehicle_height_m)
  {
  }

  void add(const Part& part, const Eigen::Isometry3d& T_map_body)
  {
    std::vector<Eigen::Vector3d> raised;  // z over the ground
    raised.reserve(part.vertices.size());
    for (const Eigen::Vector3f& vertex : part.vertices)
    {
      raised.push_back(overGround(T_map_body * vertex.cast<double>()));
    }
    std::vector<Eigen::Vector2d> points;
    for (const std::array<uint32_t, 3>& triangle : part.triangles)
    {
      const Clipped whole({raised[triangle[0]], raised[triangle[1]], raised[triangle[2]]});
      const Clipped low = whole.finite() ? whole.between(2, 0, vehicle_height_m_) : whole;
      if (!low.empty() && low.finite())
      {
        low.forEachCorner([&](double x, double y) { points.emplace_back(x, y); });
        height_m_ = std::max(height_m_, low.along(2).max);
      }
    }
    keep(geometry::convexHull(std::move(points)));
  }

  void add(const Ball& ball, const Eigen::Isometry3d& T_map_body)
  {
    const Eigen::Vector3d centre = overGround(T_map_body * ball.centre.cast<double>());
    const double radius_m = ball.radius_m;
    const double widest_at = std::clamp(centre.z(), 0.0, vehicle_height_m_);
    const double off = widest_at - centre.z();
    const double width2 = radius_m * radius_m - off * off;
    if (!(width2 > 0))
    {
      return;
    }
    constexpr int kCorners = 32;
    std::vector<Eigen::Vector2d> points;
    points.reserve(kCorners);
    for (int i = 0; i < kCorners; ++i)
    {
      const geometry::SinCos v = geometry::sinCosOf(2 * geometry::kPi * i / kCorners);
      points.emplace_back(
          centre.x() + std::sqrt(width2) * v.cos, centre.y() + std::sqrt(width2) * v.sin);
    }
    height_m_ = std::max(height_m_, std::min(centre.z() + radius_m, vehicle_height_m_));
    keep(geometry::convexHull(std::move(points)));
  }

  double height_m() const { return height_m_; }

  std::vector<Outline> take() { return std::move(outlines_); }

 private:
  Eigen::Vector3d overGround(const Eigen::Vector3d& p) const
  {
    return {p.x(), p.y(), p.z() - terrain_.at(p.x(), p.y()).height_m};
  }

  void keep(Outline outline)
  {
    if (outline.empty() || std::any_of(
                               outlines_.begin(), outlines_.end(),
                               [&](const Outline& o) { return within(outline, o); }))
    {
      return;
    }
    std::erase_if(outlines_, [&](const Outline& o) { return within(o, outline); });
    outlines_.push_back(std::move(outline));
  }

  const Terrain& terrain_;
  double vehicle_height_m_;
  double height_m_ = 0;
  std::vector<Outline> outlines_;
};

Footprint footprintOf(const Object& object, Standing standing, double at_s)
{
  checkTriangles(object);
  const Eigen::Isometry3d T_map_body = object.motion.at(at_s);
  for (const Part& part : object.parts)
  {
    if (!yields(part.material))
    {
      standing.add(part, T_map_body);
    }
  }
  for (const Ball& ball : object.balls)
  {
    if (!yields(ball.material))
    {
      standing.add(ball, T_map_body);
    }
  }
  return {Scene::kNoObject, object.name, object.label, standing.height_m(), standing.take()};
}
}  // namespace

std::vector<Footprint> footprints(const Scene& scene, const geometry::Vehicle& vehicle, double at_s)
{
  if (!scene.terrain)
  {
    throw std::invalid_argument("a scene without ground has no truth");
  }
  std::vector<Footprint> all;
  for (size_t i = 0; i < scene.objects.size(); ++i)
  {
    Footprint footprint =
        footprintOf(scene.objects[i], Standing(*scene.terrain, vehicle.height_m), at_s);
    footprint.object = Scene::kFirstObject + static_cast<uint32_t>(i);
    if (!footprint.outlines.empty())
    {
      all.push_back(std::move(footprint));
    }
  }
  return all;
}
}  // namespace traverse::simulation
