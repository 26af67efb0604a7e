// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/formats/bytes.h>
#include <traverse/multi_lidar_grid/state.h>

#include <string>

// The sections of the map's archive. Readers take hostile bytes and throw formats::FormatError.
namespace traverse::multi_lidar_grid
{
/** Times further from 1970 than this are none: differences of two must fit. */
inline constexpr poses::TimeNs kLastTime = poses::TimeNs{1} << 61U;

poses::TimeNs readTime(formats::ByteReader& in);

/** Where the region is, the time, and the robot. */
std::string gridBytes(const State& state);
void readGrid(formats::ByteReader in, State& state);

/** What is known of each sensor but its latest cloud and its clock's evidence. */
std::string sensorBytes(const Sensors& sensors);

/** How many sensors there are, nothing else being looked at. */
uint32_t sensorCount(formats::ByteReader in);
void readSensors(formats::ByteReader in, State& state);

/** Runs of cells along x that are not empty, by growing y, then x. */
std::string cellBytes(const layers::WrappedGrid<Cell>& cells);
void readCells(formats::ByteReader in, State& state);
}  // namespace traverse::multi_lidar_grid
