// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_turns.h"

#include <traverse/geometry/lattice.h>
#include <traverse/layers/layer_set.h>
#include <traverse/points/deskew.h>
#include <traverse/simulation/build.h>
#include <traverse/simulation/footprints.h>
#include <traverse/simulation/random.h>
#include <traverse/simulation/recording.h>
#include <traverse/simulation/truth.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A vehicle with an HDL-32E that drives through a random scene, as scans in memory.
namespace traverse::testing
{
/** A scene of the paper's kind for a seed, and the drive through it. */
class SimulatedDrive
{
 public:
  explicit SimulatedDrive(uint64_t seed)
  {
    simulation::SceneParams words;
    words.extent.min_x_m = words.extent.min_y_m = -30;
    words.extent.max_x_m = words.extent.max_y_m = 30;
    words.random.style = simulation::RandomStyle::paper_3;
    words = simulation::generate(words, seed);
    scene_ = simulation::buildScene(words);
    simulation::Random random(simulation::mixed({seed, 3}));
    simulation::RecordingParams params;
    params.drive.xs_m = words.drive_xs_m;
    params.drive.ys_m = words.drive_ys_m;
    params.drive.speed_mps = random.uniform(3, 8);
    params.lidars.front().z_m = random.uniform(1.6, 2.2);
    params.ins.noise_z_m = 0.005;  // an inertial unit smooths what a satellite receiver says
    start_ = {words.drive_xs_m.front(), words.drive_ys_m.front()};
    recording_ = std::make_unique<simulation::Recording>(scene_, params, seed);
    vehicle_ = params.vehicle;
    record();
  }

  /** Whose poses the scans are placed and deskewed with. */
  enum class Poses : uint8_t
  {
    exact,
    ins,  //!< white noise of 1 cm (height 5 mm) and 0.02 deg
  };

  /** Calls f(scan, T_map_base) for every turn. */
  template <class F>
  void forEachScan(Poses poses, F&& f) const
  {
    const poses::PoseTrack track(poses == Poses::exact ? recording_->trajectory(100) : ins_poses_);
    for (const simulation::LidarTurn& turn : turns_)
    {
      const auto pose = track.at(turn.stamp);
      points::Decoded seen = decodeTurn(turn);
      if (pose && points::deskew(seen.scan, track) != points::Deskew::no_poses)
      {
        f(seen.scan.view(), pose->T_map_base);
      }
    }
  }

  /** Of every cell at the end of the drive; cells where things moved are marked as swept. */
  layers::LayerSet truth() const
  {
    const double end_s = recording_->durationSeconds();
    layers::LayerSet truth = simulation::cellTruth(scene_, vehicle_, {}, end_s, start_);
    layers::LayerSet swept = simulation::sweptCells(scene_, {}, 0, end_s);
    truth.layers.push_back(std::move(swept.layers.front()));
    return truth;
  }

  const simulation::Scene& scene() const { return scene_; }

  const geometry::Vehicle& vehicle() const { return vehicle_; }

 private:
  void record()
  {
    while (auto event = recording_->next())
    {
      if (auto* turn = std::get_if<simulation::LidarTurn>(&*event))
      {
        turns_.push_back(std::move(*turn));
      }
      else if (const auto* pose = std::get_if<simulation::InsPose>(&*event))
      {
        ins_poses_.push_back({pose->stamp, pose->T_map_base});
      }
    }
  }

  simulation::Scene scene_;
  geometry::Vehicle vehicle_;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero();
  std::unique_ptr<simulation::Recording> recording_;
  std::vector<simulation::LidarTurn> turns_;
  std::vector<poses::StampedPose> ins_poses_;
};

/** How many returns of a drive fell on each cell's ground and on what stands there, not on what the
 * vehicle fits under: by the truth's heights. */
class ReturnCounts
{
 public:
  explicit ReturnCounts(const SimulatedDrive& drive) :
      terrain_(*drive.scene().terrain), height_m_(drive.vehicle().height_m)
  {
    const simulation::Area& area = drive.scene().area;
    extent_.min = cellAt(area.min_x_m, area.min_y_m);
    extent_.max = cellAt(area.max_x_m, area.max_y_m);
    counts_.resize(static_cast<size_t>(extent_.width()) * static_cast<size_t>(extent_.height()));
  }

  void add(const points::Scan& scan, const Eigen::Isometry3d& T_map_base)
  {
    for (size_t i = 0; i < scan.size(); ++i)
    {
      const Eigen::Vector3d p =
          T_map_base * Eigen::Vector3f(scan.x[i], scan.y[i], scan.z[i]).cast<double>();
      const geometry::CellIndex cell = cellAt(p.x(), p.y());
      if (extent_.contains(cell) && p.z() < terrain_.at(p.x(), p.y()).base_m + height_m_)
      {
        ++counts_[indexOf(cell)];
      }
    }
  }

  /** The map with a layer `returns`. */
  layers::LayerSet with(layers::LayerSet map) const
  {
    std::vector<uint32_t> returns;
    returns.reserve(map.size());
    for (int32_t y = map.extent.min.y; y < map.extent.max.y; ++y)
    {
      for (int32_t x = map.extent.min.x; x < map.extent.max.x; ++x)
      {
        returns.push_back(extent_.contains({x, y}) ? counts_[indexOf({x, y})] : 0);
      }
    }
    map.layers.push_back({"returns", "1", std::move(returns)});
    return map;
  }

 private:
  geometry::CellIndex cellAt(double x_m, double y_m) const
  {
    return lattice_.cellOf(geometry::toMillimetres(x_m), geometry::toMillimetres(y_m));
  }

  size_t indexOf(geometry::CellIndex c) const
  {
    return static_cast<size_t>(c.y - extent_.min.y) * static_cast<size_t>(extent_.width()) +
           static_cast<size_t>(c.x - extent_.min.x);
  }

  const simulation::Terrain& terrain_;
  double height_m_;
  geometry::Lattice lattice_;
  geometry::CellRect extent_;
  std::vector<uint32_t> counts_;
};
}  // namespace traverse::testing
