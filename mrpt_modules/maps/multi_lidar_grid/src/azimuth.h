// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace traverse::multi_lidar_grid
{
/** Azimuth of (x, y) in turns, [0, 1), counter-clockwise from x, to 1e-6 of a turn: 0.5 mm at 80 m.
 * The same bits on every processor, and without a branch. (x, y) is finite and not (0, 0). */
inline float turnOf(float x, float y)
{
  const float across = __builtin_fabsf(y);
  const float along = __builtin_fabsf(x);
  const bool is_steep = across > along;
  const float q = (is_steep ? along : across) / (is_steep ? across : along);
  const float q2 = q * q;
  // atan(q) / (2 pi) on [0, 1], fitted to least error.
  const float first =
      q * (0.159151318F +
           q2 * (-0.0529385698F +
                 q2 * (0.0308029125F +
                       q2 * (-0.0185298484F + q2 * (0.0083790755F + q2 * -0.00186515209F)))));
  const float upper = is_steep ? 0.25F - first : first;
  const float half = x < 0 ? 0.5F - upper : upper;
  const float turn = y < 0 ? 1.0F - half : half;
  return turn < 1.0F ? turn : 0.0F;
}
}  // namespace traverse::multi_lidar_grid
