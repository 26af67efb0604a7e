// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "renderer.h"

namespace traverse::rendering
{
/** Writes title, legend and, where metres_per_px > 0, a scale bar over the picture. */
void drawOverlay(
    formats::Raster& picture, const Overlay& overlay, double metres_per_px, Renderer& renderer);

/** A length of 1, 2 or 5 times a power of ten, the longest not above `most` (> 0). */
double roundLength(double most);
}  // namespace traverse::rendering
