// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/exact_trig.h>

namespace traverse::geometry
{
double minTurningRadius_m(const Drivetrain& drivetrain)
{
  if (drivetrain.steering == Steering::differential)
  {
    return 0;
  }
  const SinCos steer = sinCosOf(drivetrain.max_steer_deg * kPi / 180);
  return drivetrain.wheelbase_m * steer.cos / steer.sin;
}
}  // namespace traverse::geometry
