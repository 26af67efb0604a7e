// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simulated_turns.h"

#include <traverse/points/deskew.h>

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace traverse::testing
{
namespace
{
using simulation::Event;
using simulation::InsPose;
using simulation::kRecordingStart;
using simulation::LidarTurn;
using simulation::OdometryPose;
using simulation::Recording;
using simulation::RecordingParams;

/** One second of a vehicle that drives 15 m/s, with a small lidar. */
RecordingParams shortDrive()
{
  RecordingParams params;
  params.drive.xs_m = {-10, 0, 10};
  params.drive.ys_m = {0, 0, 2};
  params.drive.speed_mps = 15;
  params.drive.accel_mps2 = 0;
  params.drive.duration_s = 1;
  params.lidars = {perfectLidar(sensors::VelodyneModel::vlp16)};
  return params;
}

/** A small plane: its mesh is made for each recording. */
simulation::Scene field()
{
  simulation::Scene scene = planeScene();
  scene.area = {-25, -25, 25, 25};
  return scene;
}

poses::TimeNs arrivalOf(const Event& event)
{
  return std::visit([](const auto& e) { return e.arrival; }, event);
}

/** What can be compared of an event. */
struct Digest
{
  poses::TimeNs stamp = 0;
  poses::TimeNs arrival = 0;
  std::vector<std::array<uint8_t, sensors::kVelodynePacketBytes>> packets;
  double x_m = 0;

  friend bool operator==(const Digest&, const Digest&) = default;
};

Digest digestOf(const Event& event)
{
  Digest digest;
  std::visit(
      [&](const auto& e)
      {
        digest.stamp = e.stamp;
        digest.arrival = e.arrival;
      },
      event);
  if (const auto* turn = std::get_if<LidarTurn>(&event))
  {
    digest.packets = turn->packets;
  }
  if (const auto* pose = std::get_if<InsPose>(&event))
  {
    digest.x_m = pose->T_map_base.translation().x();
  }
  if (const auto* pose = std::get_if<OdometryPose>(&event))
  {
    digest.x_m = pose->x_m;
  }
  return digest;
}

std::vector<Digest> allOf(Recording& recording)
{
  std::vector<Digest> all;
  while (const auto event = recording.next())
  {
    all.push_back(digestOf(*event));
  }
  return all;
}

TEST(Recording, HasEventsInOrderOfArrival)
{
  RecordingParams params = shortDrive();
  params.lidars.push_back(params.lidars.front());
  params.lidars.back().start_s = 0.03;
  params.lidars.back().late_s = 0.25;
  Recording recording(field(), params, 1);
  poses::TimeNs last = 0;
  size_t events = 0;
  while (const auto event = recording.next())
  {
    EXPECT_GE(arrivalOf(*event), last);
    last = arrivalOf(*event);
    ++events;
  }
  EXPECT_EQ(events, 9U + 9U + 51U + 21U);  // the last turns end after the recording
  EXPECT_EQ(recording.progress(), 1);
}

TEST(Recording, IsTheSameForTheSameSeedOnly)
{
  Recording one(field(), shortDrive(), 1);
  Recording again(field(), shortDrive(), 1);
  Recording other(field(), shortDrive(), 2);
  const std::vector<Digest> events = allOf(one);
  EXPECT_EQ(events, allOf(again));
  EXPECT_NE(events, allOf(other));
}

TEST(Recording, IsTheSameWhenTwoThreadsMakeIt)
{
  RecordingParams params = shortDrive();
  params.lidars.front().rain_share = 0.1;
  Recording in_order(field(), params, 1);
  const std::vector<Digest> events = allOf(in_order);
  Recording planned(field(), params, 1);
  std::vector<Recording::Planned> plans;
  while (const auto plan = planned.plan())
  {
    plans.push_back(*plan);
  }
  ASSERT_EQ(plans.size(), events.size());
  std::vector<Digest> made(plans.size());
  const auto make_every_second = [&](size_t from)
  {
    for (size_t i = from; i < plans.size(); i += 2)
    {
      made[i] = digestOf(planned.make(plans[i]));
    }
  };
  std::thread other(make_every_second, 1);
  make_every_second(0);
  other.join();
  EXPECT_EQ(made, events);
}

TEST(Recording, GoesOnWhereItIsToldTo)
{
  RecordingParams params = shortDrive();
  params.lidars.front().repeat_every = 3;
  params.lidars.front().turn_loss = 0.3;
  params.ins.drop_out = 0.3;
  Recording whole(field(), params, 1);
  const std::vector<Digest> events = allOf(whole);
  const poses::TimeNs middle = kRecordingStart + 500'000'000;
  Recording second_half(field(), params, 1);
  second_half.seek(middle);
  std::vector<Digest> expected;
  std::copy_if(
      events.begin(), events.end(), std::back_inserter(expected),
      [&](const Digest& e) { return e.arrival >= middle; });
  EXPECT_GT(expected.size(), 10U);
  EXPECT_EQ(allOf(second_half), expected);
}

TEST(Recording, TellsTheExactTrajectory)
{
  Recording recording(field(), shortDrive(), 1);
  const poses::PoseTrack track(recording.trajectory(100));
  for (int i = 0; i < 27; ++i)
  {
    const double t_s = 0.0013 + 0.0371 * i;
    const auto time = kRecordingStart + static_cast<poses::TimeNs>(t_s * 1e9);
    const auto pose = track.at(time);
    ASSERT_TRUE(pose);
    EXPECT_LT(
        (pose->T_map_base.matrix() -
         recording.drive().at(poses::secondsBetween(kRecordingStart, time)).matrix())
            .norm(),
        1e-7);  // seconds since 1970 as doubles would be off by 1e-7 s, times 15 m/s
  }
}

TEST(Recording, FaultyLidarsDoWhatIsAskedForAndNoMore)
{
  RecordingParams params = shortDrive();
  const auto turns_with = [&](auto&& change)
  {
    RecordingParams changed = params;
    change(changed.lidars.front());
    Recording recording(field(), changed, 1);
    return eventsOf<LidarTurn>(recording);
  };
  const auto sound = turns_with([](auto& /*lidar*/) {});
  ASSERT_EQ(sound.size(), 9U);
  const auto late = turns_with([](auto& lidar) { lidar.late_s = 0.125; });
  EXPECT_EQ(late[4].stamp, sound[4].stamp);
  EXPECT_EQ(late[4].arrival, sound[4].arrival + 125'000'000);
  const auto ahead = turns_with([](auto& lidar) { lidar.clock_offset_s = 0.5; });
  EXPECT_EQ(ahead[4].stamp, sound[4].stamp + 500'000'000);
  EXPECT_EQ(ahead[4].arrival, sound[4].arrival);
  const auto dead = turns_with([](auto& lidar) { lidar.dead_after_s = 0.45; });
  EXPECT_EQ(dead.size(), 4U);
  const auto doubled = turns_with([](auto& lidar) { lidar.repeat_every = 3; });
  ASSERT_EQ(doubled.size(), 12U);
  EXPECT_EQ(doubled[2].packets, doubled[3].packets);
  EXPECT_EQ(doubled[2].stamp, doubled[3].stamp);
  EXPECT_NE(doubled[3].stamp, doubled[4].stamp);
  const auto backward = turns_with([](auto& lidar) { lidar.backward_every = 4; });
  EXPECT_EQ(backward[3].stamp, sound[3].stamp - 150'000'000);
  EXPECT_LT(backward[3].stamp, backward[2].stamp);
  EXPECT_EQ(backward[4].packets, sound[4].packets);
  EXPECT_LT(turns_with([](auto& lidar) { lidar.turn_loss = 0.5; }).size(), 9U);
}

TEST(Recording, InsHasItsNoiseItsClockAndItsSilence)
{
  RecordingParams params = shortDrive();
  params.lidars.clear();
  params.drive.duration_s = 100;
  params.ins.noise_xy_m = 0.05;
  params.ins.clock_offset_s = 0.02;
  params.ins.drop_out = 0.1;
  params.ins.dead_after_s = 60;
  Recording recording(field(), params, 1);
  const auto poses = eventsOf<InsPose>(recording);
  const double n = 60 * 50 * 0.9;
  EXPECT_NEAR(static_cast<double>(poses.size()), n, 5 * std::sqrt(n * 0.1));
  double squares = 0;
  for (const InsPose& pose : poses)
  {
    EXPECT_EQ(pose.stamp, pose.arrival + 20'000'000);
    const double t_s = poses::secondsBetween(kRecordingStart, pose.arrival);
    const double error_m =
        (pose.T_map_base.translation() - recording.drive().at(t_s).translation()).x();
    squares += error_m * error_m;
  }
  EXPECT_NEAR(std::sqrt(squares / n), 0.05, 0.05 * (5 / std::sqrt(2 * n) + 0.02));
}

TEST(Recording, OdometryDriftsAsItIsTold)
{
  RecordingParams params = shortDrive();
  params.lidars.clear();
  params.drive.xs_m = {10, 110};
  params.drive.ys_m = {5, 5};
  params.drive.duration_s = 0;
  params.odometry.scale_error = 0.02;
  params.odometry.yaw_drift_degpm = 0.1;
  params.odometry.noise_share = 0;
  params.odometry.noise_degpm = 0;
  Recording recording(field(), params, 1);
  const auto poses = eventsOf<OdometryPose>(recording);
  ASSERT_GT(poses.size(), 100U);
  EXPECT_EQ(poses.front().x_m, 0);
  const OdometryPose& end = poses.back();
  const double way_m =
      recording.drive().at(poses::secondsBetween(kRecordingStart, end.arrival)).translation().x() -
      10;
  const double turned_rad = 0.1 * way_m * M_PI / 180;
  EXPECT_NEAR(end.yaw_rad, turned_rad, 1e-9);
  // a circle's arc, in steps of 0.75 m that go straight on
  EXPECT_NEAR(end.x_m, 1.02 * way_m * std::sin(turned_rad) / turned_rad, 0.02);
  EXPECT_NEAR(end.y_m, 1.02 * way_m * (1 - std::cos(turned_rad)) / turned_rad, 0.1);
}
}  // namespace
}  // namespace traverse::testing
