// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/png.h>

#include <memory>
#include <string>

namespace traverse::formats
{
/** An animated GIF that repeats for ever, a picture at a time, by giflib. Colours are rounded to a
 * cube of 6 x 6 x 6 and 40 greys: for pictures of few colours, as maps are. The same pictures give
 * the same bytes. */
class AnimatedGif
{
 public:
  /** Pictures of these sizes, 1 to 65535, each shown for so many hundredths of a second (0 to
   * 65535). Throws std::invalid_argument. */
  AnimatedGif(int width_px, int height_px, int delay_cs);
  ~AnimatedGif();
  AnimatedGif(AnimatedGif&&) noexcept;
  AnimatedGif& operator=(AnimatedGif&&) noexcept;

  /** Throws std::invalid_argument for a picture of another size, std::runtime_error where giflib
   * refuses. */
  void add(const Raster& picture);

  /** The file's bytes; nothing can be added afterwards. */
  std::string take();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace traverse::formats
