// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "renderer.h"

#include <mrpt/opengl/CFBORender.h>

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

namespace traverse::rendering
{
namespace
{
constexpr int kLongestSide = 4096;

/** MRPT's renderer writes beyond its image where a row is no multiple of 4 pixels. */
int roundedUp(int samples)
{
  return (samples + 3) / 4 * 4;
}

/** The one line of an MRPT exception that says something. */
std::string reasonIn(std::string_view text)
{
  constexpr std::string_view kMark = "Message:";
  const size_t mark = text.find(kMark);
  text.remove_prefix(mark == std::string_view::npos ? 0 : mark + kMark.size());
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return std::string(text.substr(0, text.find('\n')));
}

template <class F>
auto reporting(F&& work)
{
  try
  {
    return work();
  }
  catch (const std::exception& e)
  {
    throw RenderError(fmt::format(
        "no picture can be drawn here ({}); off-screen rendering needs the packages libegl1, "
        "libegl-mesa0 and libgl1-mesa-dri",
        reasonIn(e.what())));
  }
}

/** Mean of the samples of a pixel. */
layers::Colour pixel(const mrpt::img::CImage& image, size_t column, size_t row)
{
  constexpr unsigned kSamples = Renderer::kSamples;
  unsigned r = 0;
  unsigned g = 0;
  unsigned b = 0;
  for (unsigned dy = 0; dy < kSamples; ++dy)
  {
    for (unsigned dx = 0; dx < kSamples; ++dx)
    {
      // OpenCV keeps blue, green, red.
      const uint8_t* bgr = image.ptr<uint8_t>(
          static_cast<unsigned>(column) * kSamples + dx, static_cast<unsigned>(row) * kSamples + dy,
          0);
      b += bgr[0];
      g += bgr[1];
      r += bgr[2];
    }
  }
  constexpr unsigned kCount = kSamples * kSamples;
  const auto mean = [](unsigned sum) { return static_cast<uint8_t>((sum + kCount / 2) / kCount); };
  return {mean(r), mean(g), mean(b)};
}
}  // namespace

Renderer::Renderer(const PictureSize& size) :
    size_(size),
    sample_width_(roundedUp(size.width_px * kSamples)),
    sample_height_(roundedUp(size.height_px * kSamples))
{
  if (std::min(size.width_px, size.height_px) < 1 ||
      std::max(size.width_px, size.height_px) > kLongestSide)
  {
    throw RenderError(fmt::format(
        "a picture of {} x {} pixels: sides are 1 to {}", size.width_px, size.height_px,
        kLongestSide));
  }
  reporting(
      [&]
      {
        fbo_ = std::make_unique<mrpt::opengl::CFBORender>(
            static_cast<unsigned>(sample_width_), static_cast<unsigned>(sample_height_));
      });
}

Renderer::~Renderer() = default;

formats::Raster Renderer::render(
    const mrpt::opengl::COpenGLScene& scene, const mrpt::opengl::CCamera& camera)
{
  mrpt::img::CImage image;
  reporting(
      [&]
      {
        fbo_->getCamera(scene) = camera;
        fbo_->render_RGB(scene, image);
      });
  formats::Raster raster(static_cast<size_t>(size_.width_px), static_cast<size_t>(size_.height_px));
  for (size_t row = 0; row < raster.height; ++row)
  {
    for (size_t column = 0; column < raster.width; ++column)
    {
      raster.at(column, row) = pixel(image, column, row);
    }
  }
  return raster;
}
}  // namespace traverse::rendering
