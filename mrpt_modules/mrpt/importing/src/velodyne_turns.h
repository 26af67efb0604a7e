// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "entries.h"

#include <traverse/sensors/velodyne_packet.h>

#include <memory>
#include <optional>
#include <span>

namespace mrpt::obs
{
class CObservationVelodyneScan;
}  // namespace mrpt::obs

namespace traverse::importing
{
/** Collects the data packets of one Velodyne into observations of one turn each. */
class VelodyneTurns
{
 public:
  explicit VelodyneTurns(SensorAt sensor) : sensor_(std::move(sensor)) {}

  /** False for what is no data packet of a known model, or not of the first one's. */
  bool add(std::span<const uint8_t> packet, poses::TimeNs captured);

  /** The turn that the last packet ended. */
  std::optional<Entry> takeFinished();

  /** The turn at the end, which may be a part of one. */
  std::optional<Entry> finish();

 private:
  void begin(const sensors::VelodyneData& data, poses::TimeNs captured);
  poses::TimeNs stampOf(const sensors::VelodyneData& data, poses::TimeNs captured);

  SensorAt sensor_;
  std::shared_ptr<mrpt::obs::CObservationVelodyneScan> turn_;
  std::shared_ptr<mrpt::obs::CObservationVelodyneScan> finished_;
  std::optional<sensors::VelodyneModel> model_;
  std::optional<poses::TimeNs> hour_;  // when the sensor's hour began, by the capture's clock
  uint16_t last_azimuth_ = 0;
};
}  // namespace traverse::importing
