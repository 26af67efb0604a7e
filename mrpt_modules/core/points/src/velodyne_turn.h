// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/sensors/velodyne_packet.h>

#include <span>
#include <vector>

namespace traverse::points
{
/** A good packet and when its first laser fired. */
struct TimedPacket
{
  sensors::VelodyneData data;
  int64_t time_ns = 0;  //!< since the first good packet
};

/** The good packets of a turn: all of the first one's model. */
struct VelodyneTurn
{
  std::vector<TimedPacket> packets;
  uint64_t bad_packets = 0;
};

VelodyneTurn checkPackets(std::span<const sensors::VelodynePacket> packets);

/** Which firing sequences become columns of the range image. */
struct ColumnPlan
{
  int sequences = 0;            //!< the first ones, within one turn
  bool closes = false;          //!< they go all the way round
  int step_hundredths_deg = 0;  //!< typical azimuth from one sequence's group to the next
};

ColumnPlan planColumns(const VelodyneTurn& turn);
}  // namespace traverse::points
