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
/** The bit that each sensor has in the archive, whose labels stand in the order of the alphabet,
 * whichever sensor came first. */
std::vector<uint32_t> archivedBits(const std::vector<std::string>& sensors);

std::string sensorBytes(std::vector<std::string> sensors);
void readSensors(formats::ByteReader in, std::vector<std::string>& sensors);

std::string drivenBytes(const DrivenCells& driven);
void readDriven(formats::ByteReader in, DrivenCells& driven);
}  // namespace traverse::traversability_grid
