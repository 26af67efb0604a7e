// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include "renderer.h"

#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/Visualizable.h>
#include <mrpt/opengl/stock_objects.h>

#include <array>
#include <cmath>
#include <limits>

namespace traverse::rendering
{
namespace
{
using mrpt::opengl::CSetOfObjects;

constexpr double kNearEnough_m = 1e4;  // float is good to 1 mm there
constexpr double kEmptyReach_m = 5;
constexpr double kAboveAll_m = 1;
constexpr double kLift_m = 0.05;  // a line in the ground would flicker with it
constexpr layers::Colour kTrajectory = {20, 20, 20};
constexpr double kTrajectoryWidth = 0.004;  // of the content's longer side

/** A growing box of finite points. */
struct Box
{
  Eigen::Vector3d min = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d max = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

  void add(const Eigen::Vector3d& p)
  {
    if (p.allFinite())
    {
      min = min.cwiseMin(p);
      max = max.cwiseMax(p);
    }
  }

  bool empty() const { return !(min.x() <= max.x()); }
};

Eigen::Vector3d toEigen(const mrpt::math::TPoint3D& p)
{
  return {p.x, p.y, p.z};
}

/** The maps' objects, and the box around them, in the map frame. */
Box visualise(const SceneContent& content, CSetOfObjects& objects)
{
  Box box;
  for (const mrpt::opengl::Visualizable* map : content.maps)
  {
    map->getVisualizationInto(objects);
  }
  for (const auto& object : objects)
  {
    const auto bounds = object->getBoundingBox();
    const Eigen::Vector3d low = toEigen(bounds.min);
    const Eigen::Vector3d high = toEigen(bounds.max);
    if (low.allFinite() && high.allFinite() && (low.array() <= high.array()).all())
    {
      box.add(low);
      box.add(high);
    }
  }
  return box;
}

void addMarkersTo(Box& box, const SceneContent& content)
{
  if (content.T_map_base)
  {
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(content.axes_length_m);
    box.add(content.T_map_base->translation() - reach);
    box.add(content.T_map_base->translation() + reach);
  }
  for (const Eigen::Vector3d& p : content.trajectory)
  {
    box.add(p);
  }
  for (const PointSet& scan : content.scans)
  {
    for (const Eigen::Vector3d& p : scan.points)
    {
      box.add(p);
    }
  }
}

/** Points of the map frame to those of the scene. */
class Placement
{
 public:
  Placement(const Eigen::Vector3d& origin, std::optional<double> height) :
      origin_(origin), height_(height)
  {
  }

  Eigen::Vector3d fromOrigin(const Eigen::Vector3d& p_map) const { return p_map - origin_; }

  /** For what is drawn on the map: lifted. */
  Eigen::Vector3d of(const Eigen::Vector3d& p_map) const
  {
    Eigen::Vector3d p = fromOrigin(p_map);
    p.z() = height_.value_or(p.z() + kLift_m);
    return p;
  }

 private:
  Eigen::Vector3d origin_;
  std::optional<double> height_;
};

/** A flat ribbon: the graphics draw lines one sample wide, whatever width they are asked for. */
mrpt::opengl::CRenderizable::Ptr trajectoryRibbon(
    const std::vector<Eigen::Vector3d>& trajectory, double width_m, const Placement& placement)
{
  auto ribbon = mrpt::opengl::CSetOfTriangles::Create();
  const auto insert = [&](const std::array<Eigen::Vector3d, 3>& corners)
  {
    mrpt::opengl::TTriangle t;
    for (size_t i = 0; i < corners.size(); ++i)
    {
      const Eigen::Vector3f p = corners[i].cast<float>();
      t.vertices[i].xyzrgba.pt = {p.x(), p.y(), p.z()};
    }
    t.setColor(toMrpt(kTrajectory));
    t.computeNormals();
    ribbon->insertTriangle(t);
  };
  for (size_t i = 1; i < trajectory.size(); ++i)
  {
    const Eigen::Vector3d a = placement.of(trajectory[i - 1]);
    const Eigen::Vector3d b = placement.of(trajectory[i]);
    const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(b - a);
    if (!side.allFinite() || side.norm() == 0)
    {
      continue;
    }
    const Eigen::Vector3d half = side.normalized() * width_m / 2;
    insert({a - half, b - half, b + half});
    insert({a - half, b + half, a + half});
  }
  return ribbon;
}

mrpt::opengl::CRenderizable::Ptr pointCloud(const PointSet& scan, const Placement& placement)
{
  auto cloud = mrpt::opengl::CPointCloud::Create();
  cloud->setColor_u8(toMrpt(scan.colour));
  cloud->setPointSize(scan.size_px * Renderer::kSamples);
  for (const Eigen::Vector3d& p_map : scan.points)
  {
    const Eigen::Vector3f p = placement.of(p_map).cast<float>();
    if (p.allFinite())
    {
      cloud->insertPoint(p.x(), p.y(), p.z());
    }
  }
  return cloud;
}

mrpt::opengl::CRenderizable::Ptr robotAxes(const SceneContent& content, const Placement& placement)
{
  auto axes = mrpt::opengl::stock_objects::CornerXYZ(static_cast<float>(content.axes_length_m));
  Eigen::Matrix4d T = content.T_map_base->matrix();
  T.topRightCorner<3, 1>() = placement.of(content.T_map_base->translation());
  axes->setPose(mrpt::poses::CPose3D(mrpt::math::CMatrixDouble44(T)));
  return axes;
}

/** Where float is good enough, the map frame itself; otherwise a point in the middle. */
Eigen::Vector3d originFor(const Box& box)
{
  if (std::max(box.min.norm(), box.max.norm()) < kNearEnough_m)
  {
    return Eigen::Vector3d::Zero();
  }
  return ((box.min + box.max) / 2).array().floor();
}

void insertMaps(mrpt::opengl::COpenGLScene& scene, CSetOfObjects& objects, const Placement& place)
{
  for (const auto& object : objects)
  {
    // Each object by itself, in double: a pose above them all would be multiplied in float.
    const mrpt::math::TPose3D pose = object->getPose();
    const Eigen::Vector3d at = place.fromOrigin({pose.x, pose.y, pose.z});
    object->setPose(mrpt::math::TPose3D(at.x(), at.y(), at.z(), pose.yaw, pose.pitch, pose.roll));
    scene.insert(object);
  }
}

void insertMarkers(
    mrpt::opengl::COpenGLScene& scene,
    const SceneContent& content,
    double ribbon_m,
    const Placement& place)
{
  for (const PointSet& scan : content.scans)
  {
    scene.insert(pointCloud(scan, place));
  }
  if (!content.trajectory.empty())
  {
    scene.insert(trajectoryRibbon(content.trajectory, ribbon_m, place));
  }
  if (content.T_map_base && content.T_map_base->matrix().allFinite())
  {
    scene.insert(robotAxes(content, place));
  }
}
}  // namespace

mrpt::img::TColor toMrpt(layers::Colour colour)
{
  return {colour.r, colour.g, colour.b};
}

BuiltScene buildScene(const SceneContent& content, Markers markers)
{
  CSetOfObjects objects;
  Box box = visualise(content, objects);
  addMarkersTo(box, content);
  if (box.empty())
  {
    box.add(Eigen::Vector3d(-kEmptyReach_m, -kEmptyReach_m, 0));
    box.add(Eigen::Vector3d(kEmptyReach_m, kEmptyReach_m, 0));
  }
  const Eigen::Vector3d origin = originFor(box);
  BuiltScene built{
      mrpt::opengl::COpenGLScene::Create(), origin, box.min - origin, box.max - origin};
  std::optional<double> height;
  if (markers == Markers::above_all)
  {
    height = built.max.z() + kAboveAll_m;
    built.max.z() = *height + content.axes_length_m;
  }
  const Placement place(origin, height);
  built.scene->getViewport()->setCustomBackgroundColor(
      mrpt::img::TColorf(toMrpt(content.background)));
  insertMaps(*built.scene, objects, place);
  const Eigen::Vector3d extent = box.max - box.min;
  insertMarkers(*built.scene, content, kTrajectoryWidth * std::max(extent.x(), extent.y()), place);
  return built;
}
}  // namespace traverse::rendering
