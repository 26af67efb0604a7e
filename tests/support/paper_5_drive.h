// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_turns.h"

#include <traverse/evaluation/departures.h>
#include <traverse/points/deskew.h>
#include <traverse/simulating/recording_file.h>
#include <traverse/simulating/scene_file.h>
#include <traverse/simulation/build.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/random.h>
#include <traverse/simulation/recording.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// The car of paper 5, with its lidars, in the scenes that were made for it.
namespace traverse::testing
{
/** A scene, and a car with lidars that drives through it. */
class Paper5Drive
{
 public:
  /** The INS's poses are known from the beginning, and are not among the events. */
  Paper5Drive(
      const simulation::SceneParams& words, simulation::RecordingParams params, uint64_t seed) :
      scene_(simulation::buildScene(words)), vehicle_(params.vehicle), lidars_(params.lidars)
  {
    const simulation::Ins ins(params.ins, seed);
    params.ins.rate_hz = params.odometry.rate_hz = 0;
    recording_ = std::make_unique<simulation::Recording>(scene_, params, seed);
    duration_s_ = recording_->durationSeconds();
    exact_ = poses::PoseTrack(recording_->trajectory(100));
    std::vector<poses::StampedPose> poses;
    for (uint64_t k = 0; k < ins.posesUntil(duration_s_); ++k)
    {
      const simulation::InsPose pose = ins.pose(k, recording_->drive());
      poses.push_back({pose.stamp, pose.T_map_base});
    }
    ins_ = poses::PoseTrack(std::move(poses));
  }

  static config::IniDocument ini(const std::string& scene)
  {
    return config::IniDocument::fromFile(
        std::filesystem::path(TRAVERSE_SOURCE_DIR) / "ini/scenes" / (scene + ".ini"));
  }

  /** In a street of ini/scenes/paper_5.ini: another street, speed and phases for every seed. */
  static Paper5Drive inStreet(uint64_t seed, double duration_s)
  {
    simulation::SceneParams words = simulating::readScene(ini("paper_5"));
    words.extent.min_x_m = -200;  // for the fastest drive
    words.extent.max_x_m = 200;
    words.random.drive_m = 300;
    words = simulation::generate(words, seed);
    simulation::RecordingParams params = simulating::readRecording(ini("paper_5"));
    params.drive.xs_m = words.drive_xs_m;
    params.drive.ys_m = words.drive_ys_m;
    simulation::Random random(simulation::mixed({seed, 5}));
    params.drive.speed_mps = speedFor(params.drive, random.uniform(8, 20));
    params.drive.duration_s = duration_s;
    for (simulation::LidarParams& lidar : params.lidars)
    {
      lidar.phase_deg = std::floor(random.uniform(0, 359));
      lidar.start_s = random.uniform(0, 0.1);
      lidar.dead_after_s = lidar.dead_after_s > 0 ? duration_s / 2 : 0;
    }
    return {words, params, seed};
  }

  /** The next turn of any of the lidars as it arrives; nothing at the end. */
  std::optional<simulation::LidarTurn> next()
  {
    auto event = recording_->next();
    return event ? std::optional(std::get<simulation::LidarTurn>(std::move(*event))) : std::nullopt;
  }

  /** How much a lidar's clock is ahead, s. */
  double clockOffset(const std::string& label) const
  {
    const auto found = std::find_if(
        lidars_.begin(), lidars_.end(),
        [&](const simulation::LidarParams& l) { return l.label == label; });
    return found == lidars_.end() ? 0 : found->clock_offset_s;
  }

  /** Where the vehicle is, s after the beginning. */
  Eigen::Vector3d place(double time_s) const
  {
    return recording_->drive().at(time_s).translation();
  }

  /** Whether the roof lidar has a free view to a place 15 cm above the ground of a cell, within its
   * lowest beam and 40 m. */
  bool isInView(geometry::CellIndex cell, double time_s) const
  {
    constexpr double kFarthest_m = 40;
    constexpr double kNearest_m = 4.1;  // where the lowest beam, -25 deg, is at that height
    const geometry::Lattice lattice;
    const double x = lattice.centre_m(cell.x);
    const double y = lattice.centre_m(cell.y);
    const Eigen::Vector3d to(x, y, scene_.terrain->at(x, y).height_m + 0.15);
    const Eigen::Vector3d from = place(time_s) + Eigen::Vector3d(0, 0, lidars_.front().z_m);
    const double far = (to - from).head<2>().norm();
    if (far > kFarthest_m || far < kNearest_m)
    {
      return false;
    }
    const double range = (to - from).norm();
    const simulation::Ray ray{from, (to - from) / range, time_s};
    return !(caster_->cast(ray, range).range_m < range - 0.05);
  }

  /** Of cells that stay in view for a second after a moving thing of that label left them. */
  std::vector<evaluation::Departure> departures(simulation::Label label)
  {
    caster_ = std::make_unique<simulation::RayCaster>(scene_);
    std::vector<evaluation::Departure> seen;
    for (const evaluation::Departure& departure : allDepartures(label))
    {
      const bool stays = departure.again_s > departure.left_s + 1 &&
                         isInView(departure.cell, departure.left_s + 0.2) &&
                         isInView(departure.cell, departure.left_s + 1);
      if (departure.left_s + 1 < duration_s_ && stays)
      {
        seen.push_back(departure);
      }
    }
    caster_.reset();
    return seen;
  }

  const simulation::Scene& scene() const { return scene_; }

  const geometry::Vehicle& vehicle() const { return vehicle_; }

  /** With the INS's noise of 1 cm (height 5 mm) and 0.02 deg. */
  const poses::PoseTrack& ins() const { return ins_; }

  const poses::PoseTrack& exact() const { return exact_; }

 private:
  /** As fast as asked for, with at most 5 m/s2 to the side. */
  static double speedFor(const simulation::DriveParams& drive, double asked_mps)
  {
    constexpr double kSideways = 5;  // m/s2
    double tightest_m = 1e3;
    for (size_t i = 0; i + 2 < drive.xs_m.size(); ++i)
    {
      const auto at = [&](size_t k) { return Eigen::Vector2d(drive.xs_m[k], drive.ys_m[k]); };
      const Eigen::Vector2d a = at(i + 1) - at(i);
      const Eigen::Vector2d b = at(i + 2) - at(i + 1);
      const double sine = std::abs(a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm());
      tightest_m = std::min(tightest_m, a.norm() / std::max(sine, 1e-6));
    }
    return std::min(asked_mps, std::sqrt(kSideways * tightest_m));
  }

  std::vector<evaluation::Departure> allDepartures(simulation::Label label) const
  {
    simulation::Scene movers;
    movers.area = scene_.area;
    movers.terrain = scene_.terrain;
    std::copy_if(
        scene_.objects.begin(), scene_.objects.end(), std::back_inserter(movers.objects),
        [&](const simulation::Object& o) { return o.motion.moves() && o.label == label; });
    std::vector<evaluation::MovingFrame> frames;
    for (int i = 0; i < static_cast<int>(10 * duration_s_); ++i)
    {
      const double time_s = 0.1 * i;
      frames.push_back({time_s, {}});
      for (const auto& print : simulation::footprints(movers, vehicle_, time_s))
      {
        frames.back().outlines.insert(
            frames.back().outlines.end(), print.outlines.begin(), print.outlines.end());
      }
    }
    const geometry::Lattice lattice;
    const auto cell = [&](double x_m, double y_m)
    { return lattice.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m)); };
    const simulation::Area& a = scene_.area;
    return evaluation::departuresOf(
        frames, lattice, {cell(a.min_x_m, a.min_y_m), cell(a.max_x_m, a.max_y_m)});
  }

  simulation::Scene scene_;
  geometry::Vehicle vehicle_;
  std::vector<simulation::LidarParams> lidars_;
  double duration_s_ = 0;
  std::unique_ptr<simulation::Recording> recording_;
  std::unique_ptr<simulation::RayCaster> caster_;
  poses::PoseTrack exact_;
  poses::PoseTrack ins_;
};
}  // namespace traverse::testing
