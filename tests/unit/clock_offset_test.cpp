// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "../support/simulated_turns.h"

#include <traverse/multi_lidar_grid/clock_offset.h>
#include <traverse/points/deskew.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace traverse;
using namespace traverse::testing;
using multi_lidar_grid::ClockOffset;

/** Posts and boxes on a plane. */
simulation::Scene yard()
{
  simulation::Scene scene = planeScene();
  for (int i = 0; i < 40; ++i)
  {
    const auto x = static_cast<float>((i * 37) % 83 - 40);
    const auto y = static_cast<float>((i * 53) % 79 - 40);
    const float half = i % 3 == 0 ? 1.0F : 0.15F;
    scene.objects.push_back(boxObject({x - half, y - half, 0}, {x + half, y + half, 2}));
  }
  return scene;
}

/** A VLP-16's turns along a line, at 12 m/s: a cell of 0.2 m is passed in 16 ms. */
class DriveOfClouds
{
 public:
  DriveOfClouds(const std::vector<double>& xs, const std::vector<double>& ys)
  {
    simulation::RecordingParams params;
    params.drive.xs_m = xs;
    params.drive.ys_m = ys;
    params.drive.speed_mps = 12;
    params.drive.accel_mps2 = 0;
    params.lidars.front().model = sensors::VelodyneModel::vlp16;
    params.lidars.front().z_m = 1;
    simulation::Recording recording(yard(), params, 1);
    track_ = poses::PoseTrack(recording.trajectory(100));
    for (const simulation::LidarTurn& turn : eventsOf<simulation::LidarTurn>(recording))
    {
      clouds_.push_back(decodeTurn(turn).scan);
    }
  }

  /** With a clock that is ahead by so much. */
  std::optional<double> found(double ahead_s) const
  {
    ClockOffset clock;
    for (points::ScanBuffer cloud : clouds_)
    {
      cloud.stamp += static_cast<poses::TimeNs>(ahead_s * 1e9);
      if (points::deskew(cloud, track_) == points::Deskew::corrected)
      {
        clock.add(cloud.view(), track_, 0.5, 2.0);
      }
    }
    return clock.estimate_s();
  }

 private:
  poses::PoseTrack track_;
  std::vector<points::ScanBuffer> clouds_;
};

const std::vector<double> kTurnXs = {-60, -20, 15, 30, 30, 15, -15};
const std::vector<double> kTurnYs = {-60, -55, -45, -20, 10, 32, 40};
}  // namespace

TEST(ClockOffset, IsFoundOnADriveRoundABend)
{
  const DriveOfClouds drive(kTurnXs, kTurnYs);
  for (const double ahead_s : {0.0, 0.08, -0.05, 0.2})
  {
    const std::optional<double> offset = drive.found(ahead_s);
    ASSERT_TRUE(offset) << ahead_s;
    // Half a step: 10 ms, in which the vehicle drives 12 cm.
    EXPECT_NEAR(*offset, -ahead_s, ClockOffset::kStep_s / 2) << ahead_s;
  }
  EXPECT_FALSE(drive.found(0.5)) << "beyond what is tried";
}

TEST(ClockOffset, IsNotGuessedStraightOnAtOneSpeed)
{
  EXPECT_FALSE(DriveOfClouds({-60, 60}, {0.5, 0.5}).found(0.08));
}
