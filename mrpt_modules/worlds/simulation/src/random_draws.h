// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random_plot.h"

#include <traverse/simulation/object_params.h>
#include <traverse/simulation/random.h>

#include <cmath>

// What makers of random scenes draw.
namespace traverse::simulation
{
inline int seedOf(Random& random)
{
  return static_cast<int>(random.index(1000000));
}

/** Between half and one and a half times as many. */
inline int about(int mean, Random& random)
{
  return static_cast<int>(std::floor(mean * random.uniform(0.5, 1.5) + 0.5));
}

inline double rounded(Random& random, double from, double to)
{
  return inMillimetres(random.uniform(from, to));
}

inline ObjectParams object(ObjectKind kind)
{
  ObjectParams p;
  p.kind = kind;
  return p;
}
}  // namespace traverse::simulation
