// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "support/disc_course.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace traverse::testing
{
using geometry::Steering;
using reactive::Command;
using reactive::Navigator;
using reactive::Outcome;
using reactive::Senses;

inline constexpr poses::TimeNs kStartNs = 1'700'000'000'000'000'000;

inline std::vector<std::string> namesIn(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    names.push_back(entry.path().filename());
  }
  return names;
}

/** One small driver and what it is shown, step by step, standing at the origin. */
class ReactiveDriver : public ::testing::Test
{
 protected:
  void make(const std::filesystem::path& log_folder = {})
  {
    vehicle.footprint_xs_m = {-0.2, 0.5, 0.5, -0.2};
    vehicle.footprint_ys_m = {-0.25, -0.25, 0.25, 0.25};
    vehicle.height_m = 1;
    params.reference_distance_m = 3;
    params.paths = 41;
    params.grid_resolution_m = 0.1;
    senses.now = kStartNs;
    senses.speed_limit_mps = 10;
    driver = std::make_unique<reactive::ReactiveDriver>(
        vehicle, drivetrain, params, scratch / "grids", log_folder);
  }

  Command stepAfter(double dt_s)
  {
    senses.now = poses::later(senses.now, dt_s);
    return driver->step(senses);
  }

  /** A wall around the vehicle, a hand's breadth away, points z_m high. */
  void closeIn(float z_m)
  {
    for (int k = 0; k <= 20; ++k)
    {
      const float x = -0.3F + 0.045F * static_cast<float>(k);
      const float y = -0.35F + 0.035F * static_cast<float>(k);
      senses.obstacles.insert(
          senses.obstacles.end(),
          {{x, -0.35F, z_m}, {x, 0.35F, z_m}, {-0.3F, y, z_m}, {0.6F, y, z_m}});
    }
  }

  ScratchFolder scratch;
  geometry::Vehicle vehicle;
  geometry::Drivetrain drivetrain;
  reactive::ReactiveParams params;
  Senses senses;
  std::unique_ptr<reactive::ReactiveDriver> driver;
};
}  // namespace traverse::testing
