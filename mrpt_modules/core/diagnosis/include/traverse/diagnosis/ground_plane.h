// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <vector>

namespace traverse::diagnosis
{
/** Where a ground plane may be looked for. */
enum class GroundSearch : uint8_t
{
  level,       //!< below the sensor, within kMostTilt_deg of the vehicle frame's xy plane
  any_around,  //!< any direction, but it must be seen all around the sensor, as no wall is
};

/** A plane that a scan shows: up . p = offset_m for its points p of the vehicle frame. */
struct GroundPlane
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  //!< unit, towards the sensor
  double offset_m = 0;  //!< of the plane from the vehicle frame's origin, along up
  double sensor_m = 0;  //!< height of the sensor above the plane
  double rms_m = 0;     //!< of its points
  double share = 0;     //!< of the points looked at that lie on it, 0..1

  /** How the plane leans in the vehicle frame: positive pitch, the ground ahead lies lower (the
   * sensor's frame is pitched up, or the road falls); positive roll, the left side lies lower. */
  double pitch_deg() const;
  double roll_deg() const;

  static constexpr double kMostTilt_deg = 20;
};

/** The plane with most of the points, and hardly any below it, by RANSAC (Fischler and Bolles 1981)
 * of fixed seed and a least-squares fit to its points; points at 1 to 30 m of the sensor count.
 * Nothing where no plane has a tenth of them (3 % of them, seen all around the sensor), and for
 * fewer than 100 points. */
std::optional<GroundPlane> findGround(const points::Scan& scan, GroundSearch search);

/** What several scans of one sensor agree on: medians, and how far half of the scans are from
 * them. */
struct GroundSeen
{
  size_t scans = 0;  //!< in which a ground was found
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double offset_m = 0;
  double sensor_m = 0;
  double pitch_deg = 0;
  double roll_deg = 0;
  double pitch_spread_deg = 0;
  double roll_spread_deg = 0;
  double offset_spread_m = 0;
};

/** Nothing for no planes. */
std::optional<GroundSeen> agree(std::span<const GroundPlane> planes);
}  // namespace traverse::diagnosis
