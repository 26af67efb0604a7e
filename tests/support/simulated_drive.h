// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/lattice.h>
#include <traverse/layers/layer_set.h>
#include <traverse/points/deskew.h>
#include <traverse/points/velodyne_scan.h>
#include <traverse/simulation/build.h>
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
    words.random.style = simulation::RandomStyle::paper_3;
    words = simulation::generate(words, seed);
    scene_ = simulation::buildScene(words);
    simulation::Random random(simulation::mixed({seed, 3}));
    simulation::RecordingParams params;
    params.drive.xs_m = words.drive_xs_m;
    params.drive.ys_m = words.drive_ys_m;
    params.drive.speed_mps = random.uniform(4, 10);
    params.lidars.front().z_m = random.uniform(1.6, 2.2);
    start_ = {words.drive_xs_m.front(), words.drive_ys_m.front()};
    recording_ = std::make_unique<simulation::Recording>(scene_, params, seed);
    vehicle_ = params.vehicle;
  }

  /** Calls f(scan, T_map_base) for every turn, deskewed with exact poses. */
  template <class F>
  void forEachScan(F&& f) const
  {
    const poses::PoseTrack track(recording_->trajectory(100));
    while (const auto event = recording_->next())
    {
      if (const auto* turn = std::get_if<simulation::LidarTurn>(&*event))
      {
        const auto pose = track.at(turn->stamp);
        points::Decoded decoded = decode(*turn);
        if (pose && points::deskew(decoded.scan, track) != points::Deskew::no_poses)
        {
          f(decoded.scan.view(), pose->T_map_base);
        }
      }
    }
  }

  /** Of every cell at the end of the drive. */
  layers::LayerSet truth() const
  {
    return simulation::cellTruth(scene_, vehicle_, {}, recording_->durationSeconds(), start_);
  }

  const simulation::Scene& scene() const { return scene_; }

  const geometry::Vehicle& vehicle() const { return vehicle_; }

 private:
  static points::Decoded decode(const simulation::LidarTurn& turn)
  {
    const std::vector<sensors::VelodynePacket> views(turn.packets.begin(), turn.packets.end());
    points::VelodyneInput input;
    input.packets = views;
    input.stamp = turn.stamp;
    input.sensor_label = turn.label;
    input.T_base_sensor = turn.T_base_sensor;
    return points::decodeVelodyne(input);
  }

  simulation::Scene scene_;
  geometry::Vehicle vehicle_;
  Eigen::Vector2d start_ = Eigen::Vector2d::Zero();
  std::unique_ptr<simulation::Recording> recording_;
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
