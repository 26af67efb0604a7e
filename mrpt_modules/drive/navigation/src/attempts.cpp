// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attempts.h"

#include <traverse/geometry/outline.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
/** Cells beside a strip that are as good: arcs cannot hold a line of single cells. */
constexpr int32_t kBesideStrip = 2;

/** Where there is no way otherwise: strips through what is seen from within have gaps. */
constexpr int32_t kBesideBrokenStrip = 5;

/** How much further out than when it drives straight a car's front corner goes in its tightest
 * circle. */
double swingOf(const geometry::Vehicle& vehicle, const geometry::Drivetrain& drivetrain)
{
  double front_m = 0;
  for (const Eigen::Vector2d& corner : geometry::footprintOf(vehicle))
  {
    front_m = std::max(front_m, std::abs(corner.x()));
  }
  const double side_m = geometry::minTurningRadius_m(drivetrain) + geometry::halfWidth_m(vehicle);
  return std::sqrt(side_m * side_m + front_m * front_m) - side_m;
}
}  // namespace

Attempts::Attempts(
    const geometry::Vehicle& vehicle,
    const geometry::Drivetrain& drivetrain,
    bool is_hybrid,
    bool has_margin) :
    is_hybrid_(is_hybrid), has_margin_(has_margin), swing_m_(swingOf(vehicle, drivetrain))
{
}

std::vector<Attempt> Attempts::in(const Costmap& costmap) const
{
  std::vector<Attempt> all;
  if (is_hybrid_ && has_margin_)
  {
    const auto room = static_cast<int32_t>(std::lround(swing_m_ / costmap.lattice.cell_m()));
    all.push_back({kBesideStrip, room, true, 4});
  }
  all.push_back({is_hybrid_ ? kBesideStrip : 0, 0, false, is_hybrid_ ? 4 : 1});
  if (!costmap.strip.empty())
  {
    all.push_back({kBesideBrokenStrip, 0, false, is_hybrid_ ? 2 : 1});
  }
  return all;
}
}  // namespace traverse::navigation
