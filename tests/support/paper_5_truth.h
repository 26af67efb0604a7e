// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/layer_set.h>
#include <traverse/simulation/truth.h>

#include <deque>
#include <string>
#include <support/paper_5_drive.h>
#include <utility>
#include <vector>

// What there is around the car of paper 5 at a time, and what its lidars had of it.
namespace traverse::testing
{
/** The returns of the last second, where they really were. */
class RecentReturns
{
 public:
  explicit RecentReturns(const Paper5Drive& drive) : drive_(drive) {}

  void add(const simulation::LidarTurn& turn, points::ScanBuffer scan)
  {
    scan.stamp -= static_cast<poses::TimeNs>(drive_.clockOffset(turn.label) * 1e9);
    const Eigen::Isometry3d T_sensor_base = turn.T_base_sensor.inverse();
    std::vector<uint8_t> in_view(scan.size());
    for (size_t i = 0; i < scan.size(); ++i)
    {
      in_view[i] = isInView(turn.label, T_sensor_base * at(scan, i)) ? 1 : 0;
    }
    const auto pose = drive_.exact().at(scan.stamp);
    if (!pose || points::deskew(scan, drive_.exact()) == points::Deskew::no_poses)
    {
      return;
    }
    turns_.push_back({scan.stamp, {}});
    const geometry::Lattice lattice;
    for (size_t i = 0; i < scan.size(); ++i)
    {
      const Eigen::Vector3d p = pose->T_map_base * at(scan, i);
      if (in_view[i] != 0)
      {
        const geometry::CellIndex cell =
            lattice.cellOf(geometry::toMillimetres(p.x()), geometry::toMillimetres(p.y()));
        turns_.back().returns.push_back(
            {cell, static_cast<float>(p.z()), turn.returns.at(i).object});
      }
    }
  }

  /** How many were of the thing that decides each cell, not above the vehicle's height; only those
   * of turns that began within the last second count. */
  std::vector<uint32_t> of(const layers::LayerSet& truth, double time_s)
  {
    const poses::TimeNs from =
        simulation::kRecordingStart + static_cast<poses::TimeNs>((time_s - 1.05) * 1e9);
    while (!turns_.empty() && turns_.front().stamp < from)
    {
      turns_.pop_front();
    }
    const auto& objects = std::get<std::vector<uint32_t>>(truth.find("truth_object")->data);
    const auto& ground = std::get<std::vector<float>>(truth.find("ground_height")->data);
    std::vector<uint32_t> counts(truth.size());
    for (const Turn& turn : turns_)
    {
      for (const Return& r : turn.returns)
      {
        if (truth.extent.contains(r.cell))
        {
          const geometry::CellIndex& min = truth.extent.min;
          const size_t i =
              static_cast<size_t>(r.cell.y - min.y) * static_cast<size_t>(truth.extent.width()) +
              static_cast<size_t>(r.cell.x - min.x);
          const bool low = r.z_m < ground[i] + static_cast<float>(drive_.vehicle().height_m);
          counts[i] += low && r.object == objects[i] ? 1 : 0;
        }
      }
    }
    return counts;
  }

  /** The car's body is in the wing lidars' way behind them; the simulated one has none. */
  static bool isInView(const std::string& label, const Eigen::Vector3d& p_sensor)
  {
    constexpr double kCosine = -0.342;  // of 110 deg
    return label == "ROOF" || p_sensor.x() >= kCosine * p_sensor.head<2>().norm();
  }

 private:
  struct Return
  {
    geometry::CellIndex cell;
    float z_m = 0;
    uint32_t object = 0;
  };

  struct Turn
  {
    poses::TimeNs stamp = 0;
    std::vector<Return> returns;
  };

  static Eigen::Vector3d at(const points::ScanBuffer& scan, size_t i)
  {
    return Eigen::Vector3f(scan.x[i], scan.y[i], scan.z[i]).cast<double>();
  }

  const Paper5Drive& drive_;
  std::deque<Turn> turns_;
};

/** The true cells around the vehicle at a time, with the layers returns and truth_swept. */
class TruthAround
{
 public:
  explicit TruthAround(const Paper5Drive& drive) : drive_(drive), scene_(drive.scene()) {}

  layers::LayerSet at(double time_s, RecentReturns& returns)
  {
    constexpr double kReach_m = 44;
    const Eigen::Vector3d place = drive_.place(time_s);
    const simulation::Area& all = drive_.scene().area;
    scene_.area = {
        std::max(all.min_x_m, place.x() - kReach_m), std::max(all.min_y_m, place.y() - kReach_m),
        std::min(all.max_x_m, place.x() + kReach_m), std::min(all.max_y_m, place.y() + kReach_m)};
    const simulation::TruthParams params;
    layers::LayerSet truth =
        simulation::cellTruth(scene_, drive_.vehicle(), params, time_s, place.head<2>());
    layers::LayerSet swept =
        simulation::sweptCells(scene_, params, std::max(0.0, time_s - 1), time_s);
    truth.layers.push_back(std::move(swept.layers.front()));
    truth.layers.push_back({"returns", "1", returns.of(truth, time_s)});
    leaveOutTheUnreachable(truth, params);
    return truth;
  }

 private:
  /** Ground that is flat but cannot be reached within the window is no obstacle to a sensor. */
  static void leaveOutTheUnreachable(layers::LayerSet& truth, const simulation::TruthParams& params)
  {
    const auto& roughness = std::get<std::vector<float>>(truth.find("truth_roughness")->data);
    for (layers::Layer& layer : truth.layers)
    {
      if (layer.name == "truth_state")
      {
        auto& states = std::get<std::vector<uint8_t>>(layer.data);
        for (size_t i = 0; i < states.size(); ++i)
        {
          const bool flat = roughness[i] < static_cast<float>(params.large_max_m);
          states[i] = states[i] == 2 && flat ? 0 : states[i];
        }
      }
    }
  }

  const Paper5Drive& drive_;
  simulation::Scene scene_;
};
}  // namespace traverse::testing
