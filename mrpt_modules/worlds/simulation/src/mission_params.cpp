// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/simulation/mission_params.h>

namespace traverse::simulation
{
geometry::Pose2 startOf(const MissionParams& mission)
{
  return {mission.start_x_m, mission.start_y_m, mission.start_yaw_deg * (geometry::kPi / 180)};
}

std::vector<geometry::Pose2> goalsOf(const MissionParams& mission)
{
  if (mission.goal_xs_m.size() != mission.goal_ys_m.size())
  {
    throw options::OptionError(
        "goal_xs_m, goal_ys_m",
        std::to_string(mission.goal_xs_m.size()) + " x, " +
            std::to_string(mission.goal_ys_m.size()) + " y",
        "as many x as y");
  }
  std::vector<geometry::Pose2> goals;
  geometry::Pose2 before = startOf(mission);
  for (size_t i = 0; i < mission.goal_xs_m.size(); ++i)
  {
    const double x_m = mission.goal_xs_m[i];
    const double y_m = mission.goal_ys_m[i];
    before = {x_m, y_m, geometry::angleOf(y_m - before.y_m, x_m - before.x_m)};
    goals.push_back(before);
  }
  return goals;
}
}  // namespace traverse::simulation
