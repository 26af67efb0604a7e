// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simple_scene.h"

#include <traverse/simulation/decode_turn.h>
#include <traverse/simulation/recording.h>

#include <utility>
#include <vector>

namespace traverse::testing
{
/** A lidar without faults or noise, whose every beam comes back. */
inline simulation::LidarParams perfectLidar(sensors::VelodyneModel model)
{
  simulation::LidarParams params;
  params.model = model;
  params.range_noise_m = 0;
  params.laser_bias_m = 0;
  params.half_range_m = 0;
  return params;
}

/** A vehicle that stands at map zero. */
inline simulation::Motion standingStill()
{
  return simulation::Motion();
}

inline simulation::LidarTurn turnIn(
    const simulation::Scene& scene, const simulation::LidarParams& params, uint64_t k = 0)
{
  return simulation::Lidar(params, 1).turn(k, simulation::RayCaster(scene), standingStill());
}

/** All events of a kind, in their order. */
template <class E>
std::vector<E> eventsOf(simulation::Recording& recording)
{
  std::vector<E> events;
  while (auto event = recording.next())
  {
    if (auto* wanted = std::get_if<E>(&*event))
    {
      events.push_back(std::move(*wanted));
    }
  }
  return events;
}
}  // namespace traverse::testing
