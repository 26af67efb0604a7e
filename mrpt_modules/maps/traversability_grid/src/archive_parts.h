// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/bytes.h>
#include <traverse/traversability_grid/driven.h>

#include <cstdint>
#include <string>
#include <vector>

namespace traverse::traversability_grid
{
/** Labels are archived in the order of the alphabet, whichever sensor came first. */
class SensorOrder
{
 public:
  explicit SensorOrder(const std::vector<std::string>& sensors);

  /** Bits of HeightSlab::seen_by as they are in the archive. */
  uint32_t archived(uint32_t bits) const;

 private:
  std::vector<size_t> place_;
};

std::string sensorBytes(std::vector<std::string> sensors);
void readSensors(formats::ByteReader in, std::vector<std::string>& sensors);

std::string drivenBytes(const DrivenCells& driven);
void readDriven(formats::ByteReader in, DrivenCells& driven);
}  // namespace traverse::traversability_grid
