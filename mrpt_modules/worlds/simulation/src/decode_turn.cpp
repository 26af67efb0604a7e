// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/simulation/decode_turn.h>

namespace traverse::simulation
{
points::Decoded decodeTurn(const LidarTurn& turn)
{
  const std::vector<sensors::VelodynePacket> views(turn.packets.begin(), turn.packets.end());
  points::VelodyneInput input;
  input.packets = views;
  input.stamp = turn.stamp;
  input.sensor_label = turn.label;
  input.T_base_sensor = turn.T_base_sensor;
  return points::decodeVelodyne(input);
}
}  // namespace traverse::simulation
