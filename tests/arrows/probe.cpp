// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/lattice.h>
#ifdef PROBE_forbidden
#include <mrpt/poses/CPose3D.h>
#endif

traverse::geometry::Lattice probe()
{
  return {};
}
