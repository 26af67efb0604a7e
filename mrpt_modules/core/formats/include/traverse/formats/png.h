// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>

#include <cstddef>
#include <string>
#include <vector>

namespace traverse::formats
{
/** Pixels row by row from the top left, 8 bits for each of red, green and blue. */
struct Raster
{
  size_t width = 0;
  size_t height = 0;
  std::vector<layers::Colour> pixels;  //!< width * height

  Raster() = default;

  Raster(size_t columns, size_t rows, layers::Colour fill = {}) :
      width(columns), height(rows), pixels(columns * rows, fill)
  {
  }

  layers::Colour& at(size_t column, size_t row) { return pixels[row * width + column]; }

  const layers::Colour& at(size_t column, size_t row) const { return pixels[row * width + column]; }
};

/** The bytes of a PNG file; the same pixels give the same bytes. Throws std::invalid_argument where
 * the raster is empty or its sizes do not fit. */
std::string png(const Raster& raster);

/** The class layer from above in its legend's exact colours, north (largest y) up, each cell a
 * square of equal pixels: the smallest whole number of them that makes the longer side at least
 * min_side_px. Codes without a legend entry are white. Throws std::invalid_argument where there is
 * no class layer of one byte per cell. */
Raster classPicture(const layers::LayerSet& set, size_t min_side_px = 600);
}  // namespace traverse::formats
