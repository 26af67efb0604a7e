// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/png.h>
#include <traverse/layers/layer_set.h>

#include <Eigen/Geometry>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace mrpt::opengl
{
class Visualizable;
}  // namespace mrpt::opengl

namespace traverse::rendering
{
/** Pictures cannot be drawn here: no EGL, no software renderer, or a size it cannot do. */
class RenderError : public std::runtime_error
{
 public:
  using std::runtime_error::runtime_error;
};

/** Coloured points in the map frame, metres. */
struct PointSet
{
  std::vector<Eigen::Vector3d> points;
  layers::Colour colour = {30, 30, 30};
  float size_px = 2;
};

/** What a picture shows. Maps are drawn as they visualise themselves. Coordinates are metres of the
 * map frame; beyond 10 km from its origin all is drawn relative to a near point, as the graphics
 * work in float. */
struct SceneContent
{
  std::vector<const mrpt::opengl::Visualizable*> maps;  //!< alive during the call
  std::optional<Eigen::Isometry3d> T_map_base;          //!< the robot: its axes are drawn
  double axes_length_m = 1.5;                           //!< x red, y green, z blue
  std::vector<Eigen::Vector3d> trajectory;              //!< a line
  std::vector<PointSet> scans;
  layers::Colour background = {236, 239, 243};
};

/** What is written over a picture. */
struct Overlay
{
  std::string title;
  std::vector<layers::LegendEntry> legend;
  bool scale_bar = true;  //!< top views only
};

/** Size of a picture, 1 to 4096 each. */
struct PictureSize
{
  int width_px = 1280;
  int height_px = 960;
};

/** A rectangle of the map, metres. */
struct Area
{
  double min_x_m = 0;
  double min_y_m = 0;
  double max_x_m = 0;
  double max_y_m = 0;
};

/** From where a perspective looks: at `target` of the map frame from a distance; azimuth 0 looks
 * along -x, counted counter-clockwise seen from above; elevation 90 looks straight down. */
struct Viewpoint
{
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  double distance_m = 20;
  double azimuth_deg = -135;
  double elevation_deg = 35;
};

/** Straight from above without perspective: x to the right, y up, in the colours of the objects,
 * unshaded. The whole of `area` is in the picture (by default: all that the content fills, or 10 m
 * around the origin where that is nothing), centred, with the same scale in x and y. Robot,
 * trajectory and points are drawn over the map whatever their height.
 *
 * Needs no display. Throws RenderError. May be called from any thread. */
formats::Raster renderTopView(
    const SceneContent& content,
    const Overlay& overlay = {},
    const PictureSize& size = {},
    const std::optional<Area>& area = std::nullopt);

/** In perspective and shaded. By default from behind and above, with all of it in the picture.
 * Otherwise as renderTopView. */
formats::Raster renderPerspective(
    const SceneContent& content,
    const Overlay& overlay = {},
    const PictureSize& size = {},
    const std::optional<Viewpoint>& viewpoint = std::nullopt);

/** The bytes of a .3Dscene file for MRPT's SceneViewer3D, which needs no graphics to be made. The
 * same content gives the same bytes. */
std::string sceneFile(const SceneContent& content);
}  // namespace traverse::rendering
