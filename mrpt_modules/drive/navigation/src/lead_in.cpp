// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/navigation/lead_in.h>
#include <traverse/navigation/motion.h>

#include <cmath>

namespace traverse::navigation
{
Path leadIn(const geometry::Pose2& pose, const geometry::Twist2& motion)
{
  constexpr double kLead_s = 0.4;
  constexpr double kSlow_mps = 0.2;
  Path path;
  if (std::abs(motion.speed_mps) >= kSlow_mps)
  {
    const double curvature_1pm = motion.yaw_rate_radps / motion.speed_mps;
    drive(path, posed(pose), {curvature_1pm, motion.speed_mps * kLead_s});
  }
  return path;
}

Path joined(Path lead, const Path& path)
{
  if (lead.empty() || path.empty())
  {
    return path;
  }
  const double began_m = lead.back().along_m;
  lead.pop_back();  // it is the path's first
  for (PathPoint point : path)
  {
    point.along_m += began_m;
    lead.push_back(point);
  }
  return lead;
}
}  // namespace traverse::navigation
