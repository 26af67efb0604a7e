// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/rendering/offscreen.h>

#include <mrpt/opengl/COpenGLScene.h>

namespace traverse::rendering
{
/** A scene made for one use: MRPT 2.5.8 cannot render the same one by two renderers. */
struct BuiltScene
{
  mrpt::opengl::COpenGLScene::Ptr scene;
  Eigen::Vector3d origin;  //!< of the scene, in the map frame
  Eigen::Vector3d min;     //!< what the content fills, relative to the origin
  Eigen::Vector3d max;
};

/** Where robot, trajectory and scans go. */
enum class Markers
{
  in_place,
  above_all,  //!< lifted over everything, for views from above
};

BuiltScene buildScene(const SceneContent& content, Markers markers);

mrpt::img::TColor toMrpt(layers::Colour colour);
}  // namespace traverse::rendering
