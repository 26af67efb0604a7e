// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/motion.h>

#include <cmath>

namespace traverse::navigation
{
std::vector<Shift> stepsOf(const Motion& motion)
{
  constexpr double kStep_m = 0.1;
  constexpr double kRounding = 1e-9;
  const auto steps =
      static_cast<int64_t>(std::ceil(std::abs(motion.length_m) / kStep_m - kRounding));
  std::vector<Shift> all;
  all.reserve(static_cast<size_t>(steps));
  for (int64_t k = 1; k <= steps; ++k)
  {
    const double share = static_cast<double>(k) / static_cast<double>(steps);
    all.push_back(shiftOf({motion.curvature_1pm, share * motion.length_m}));
  }
  return all;
}

void drive(Path& path, const Posed& from, const Motion& motion)
{
  const auto add = [&path](const Posed& at, double along_m)
  {
    PathPoint point;
    point.pose = {at.stand.place.x_m, at.stand.place.y_m, at.yaw_rad};
    point.along_m = along_m;
    path.push_back(point);
  };
  if (path.empty())
  {
    add(from, 0);
  }
  const std::vector<Shift> steps = stepsOf(motion);
  const double began_m = path.back().along_m;
  for (size_t k = 0; k < steps.size(); ++k)
  {
    path.back().curvature_1pm = motion.curvature_1pm;
    path.back().is_backward = motion.length_m < 0;
    const double share = static_cast<double>(k + 1) / static_cast<double>(steps.size());
    add(after(from, steps[k]), began_m + share * std::abs(motion.length_m));
    path.back().is_backward = motion.length_m < 0;
  }
}
}  // namespace traverse::navigation
