// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/rendering/offscreen.h>

#include <mrpt/opengl/CCamera.h>
#include <mrpt/opengl/COpenGLScene.h>

#include <memory>

namespace mrpt::opengl
{
class CFBORender;
}  // namespace mrpt::opengl

namespace traverse::rendering
{
/** Renders scenes into one size, each pixel from 2 x 2 samples. Keeps MRPT 2.5.8's off-screen
 * renderer within what it can do: sides that are multiples of 4, one at a time in a thread. */
class Renderer
{
 public:
  /** Throws RenderError. */
  explicit Renderer(const PictureSize& size);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /** The scene must not have been rendered before. Throws RenderError. */
  formats::Raster render(
      const mrpt::opengl::COpenGLScene& scene, const mrpt::opengl::CCamera& camera);

  /** Of the picture that the camera sees, samples: the rows and columns beyond the wanted size are
   * at its right and bottom, and cut off. */
  int sampleWidth() const { return sample_width_; }

  int sampleHeight() const { return sample_height_; }

  static constexpr int kSamples = 2;  //!< in a row of a pixel

 private:
  PictureSize size_;
  int sample_width_;
  int sample_height_;
  std::unique_ptr<mrpt::opengl::CFBORender> fbo_;
};
}  // namespace traverse::rendering
