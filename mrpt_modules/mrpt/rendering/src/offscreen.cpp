// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "overlay.h"
#include "renderer.h"
#include "scene.h"

#include <traverse/formats/gzip.h>
#include <traverse/rendering/offscreen.h>

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <numbers>

namespace traverse::rendering
{
namespace
{
using mrpt::opengl::CCamera;

/** MRPT's parallel projection shows half of the zoom distance along the shorter side. */
constexpr double kZoomPerShorterSide = 2;
constexpr double kFrame = 1.04;  // of room around what is shown
constexpr double kFieldOfView_deg = 30;

void checkArea(const Area& a)
{
  const bool finite = std::isfinite(a.min_x_m) && std::isfinite(a.min_y_m) &&
                      std::isfinite(a.max_x_m) && std::isfinite(a.max_y_m);
  if (!finite || a.max_x_m <= a.min_x_m || a.max_y_m <= a.min_y_m)
  {
    throw RenderError("the area of a picture is empty");
  }
}

Area filled(const BuiltScene& built)
{
  const Eigen::Vector3d low = built.min + built.origin;
  const Eigen::Vector3d high = built.max + built.origin;
  const double room = (kFrame - 1) / 2 * std::max({high.x() - low.x(), high.y() - low.y(), 0.1});
  return {low.x() - room, low.y() - room, high.x() + room, high.y() + room};
}

/** Unshaded: the colours that the objects have. */
void lightEvenly(mrpt::opengl::COpenGLViewport& viewport)
{
  auto& light = viewport.lightParameters();
  light.ambient = {1.0F, 1.0F, 1.0F, 1.0F};
  light.diffuse = {0.0F, 0.0F, 0.0F, 1.0F};
  light.specular = {0.0F, 0.0F, 0.0F, 1.0F};
}

void lightFromAbove(mrpt::opengl::COpenGLViewport& viewport)
{
  auto& light = viewport.lightParameters();
  light.ambient = {0.55F, 0.55F, 0.55F, 1.0F};
  light.diffuse = {0.55F, 0.55F, 0.55F, 1.0F};
  light.specular = {0.0F, 0.0F, 0.0F, 1.0F};
  light.direction = {-0.35F, 0.25F, -0.9F};
}

double metresPerPixel(const Area& area, const PictureSize& size)
{
  return std::max(
      (area.max_x_m - area.min_x_m) / size.width_px,
      (area.max_y_m - area.min_y_m) / size.height_px);
}

CCamera cameraAbove(
    const BuiltScene& built, const Area& area, const PictureSize& size, const Renderer& renderer)
{
  const double metres_per_sample = metresPerPixel(area, size) / Renderer::kSamples;
  const int extra_right = renderer.sampleWidth() - size.width_px * Renderer::kSamples;
  const int extra_below = renderer.sampleHeight() - size.height_px * Renderer::kSamples;
  const double x = (area.min_x_m + area.max_x_m) / 2 + extra_right * metres_per_sample / 2;
  const double y = (area.min_y_m + area.max_y_m) / 2 - extra_below * metres_per_sample / 2;
  const double distance = kZoomPerShorterSide * metres_per_sample *
                          std::min(renderer.sampleWidth(), renderer.sampleHeight());
  CCamera camera;
  camera.setOrthogonal();
  camera.setAzimuthDegrees(-90);
  camera.setElevationDegrees(90);
  // The eye is `distance` above what it points at: above all, as the renderer sees only forward.
  camera.setPointingAt(
      mrpt::math::TPoint3D(x - built.origin.x(), y - built.origin.y(), built.max.z()));
  camera.setZoomDistance(static_cast<float>(distance));
  constexpr double kBelow_m = 10;
  built.scene->getViewport()->setViewportClipDistances(
      static_cast<float>(distance / 2),
      static_cast<float>(distance + built.max.z() - built.min.z() + kBelow_m));
  return camera;
}

double radians(double degrees)
{
  return degrees * std::numbers::pi / 180;
}

/** The nearest point of the default direction from where all of the box is seen. */
Viewpoint viewpointOver(const BuiltScene& built, const PictureSize& size)
{
  Viewpoint view;
  const Eigen::Vector3d centre = (built.min + built.max) / 2;
  view.target = built.origin + centre;
  const double azimuth = radians(view.azimuth_deg);
  const double elevation = radians(view.elevation_deg);
  const Eigen::Vector3d to_eye(
      std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation),
      std::sin(elevation));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(to_eye).normalized();
  const Eigen::Vector3d up = to_eye.cross(right);
  const double tan_up = std::tan(radians(kFieldOfView_deg / 2));
  const double tan_right = tan_up * size.width_px / size.height_px;
  view.distance_m = 1;
  for (unsigned i = 0; i < 8; ++i)
  {
    const Eigen::Vector3d half = (built.max - built.min) / 2;
    const Eigen::Vector3d corner(
        (i & 1U) == 0 ? -half.x() : half.x(), (i & 2U) == 0 ? -half.y() : half.y(),
        (i & 4U) == 0 ? -half.z() : half.z());
    const double aside =
        kFrame *
        std::max(std::abs(corner.dot(right)) / tan_right, std::abs(corner.dot(up)) / tan_up);
    view.distance_m = std::max(view.distance_m, aside + corner.dot(to_eye));
  }
  return view;
}

CCamera cameraAt(const BuiltScene& built, const Viewpoint& view)
{
  CCamera camera;
  const Eigen::Vector3d target = view.target - built.origin;
  camera.setPointingAt(mrpt::math::TPoint3D(target.x(), target.y(), target.z()));
  camera.setZoomDistance(static_cast<float>(view.distance_m));
  camera.setAzimuthDegrees(static_cast<float>(view.azimuth_deg));
  camera.setElevationDegrees(static_cast<float>(view.elevation_deg));
  camera.setProjectiveFOVdeg(static_cast<float>(kFieldOfView_deg));
  const double reach = (built.max - built.min).norm();
  built.scene->getViewport()->setViewportClipDistances(
      static_cast<float>(std::max(0.05, (view.distance_m - reach) / 2)),
      static_cast<float>(view.distance_m + 2 * reach + 10));
  return camera;
}
}  // namespace

formats::Raster renderTopView(
    const SceneContent& content,
    const Overlay& overlay,
    const PictureSize& size,
    const std::optional<Area>& area)
{
  Renderer renderer(size);
  const BuiltScene built = buildScene(content, Markers::above_all);
  const Area shown = area.value_or(filled(built));
  checkArea(shown);
  lightEvenly(*built.scene->getViewport());
  formats::Raster picture =
      renderer.render(*built.scene, cameraAbove(built, shown, size, renderer));
  drawOverlay(picture, overlay, metresPerPixel(shown, size), renderer);
  return picture;
}

formats::Raster renderPerspective(
    const SceneContent& content,
    const Overlay& overlay,
    const PictureSize& size,
    const std::optional<Viewpoint>& viewpoint)
{
  Renderer renderer(size);
  const BuiltScene built = buildScene(content, Markers::in_place);
  lightFromAbove(*built.scene->getViewport());
  const Viewpoint view = viewpoint.value_or(viewpointOver(built, size));
  formats::Raster picture = renderer.render(*built.scene, cameraAt(built, view));
  drawOverlay(picture, overlay, 0, renderer);
  return picture;
}

std::string sceneFile(const SceneContent& content)
{
  const BuiltScene built = buildScene(content, Markers::in_place);
  mrpt::opengl::COpenGLViewport& viewport = *built.scene->getViewport();
  lightFromAbove(viewport);
  const CCamera camera = cameraAt(built, viewpointOver(built, {}));
  viewport.getCamera() = camera;
  mrpt::io::CMemoryStream stream;
  mrpt::serialization::archiveFrom(stream) << *built.scene;
  return formats::gzip(
      {static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount()});
}
}  // namespace traverse::rendering
