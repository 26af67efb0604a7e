// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_fans.h"
#include "cell_columns.h"
#include "ground_ray.h"
#include "ground_reference.h"
#include "rules.h"

#include <traverse/multi_lidar_grid/unit_map.h>

#include <array>
#include <span>

namespace traverse::multi_lidar_grid
{
/** In hit_from of an unknown cell, until the end of a cloud: something hangs over a cell, and
 * whether it is free below is for the beams to say. */
inline constexpr uint8_t kHangs = 2;

/** What all fans of a cloud have in common. */
struct FanScene
{
  const Rules& rules;
  const LocalGround& ground;
  const CellColumns& columns;
  geometry::CellRect region;
  float range_m = 0;
  bool is_level = false;  //!< a 2-D scanner: what it frees it frees at the height of its beam
};

/** Follows the beams of one fan over the ground: a cell is free where one passes lower than the
 * obstacle height, and negative where they sink into the ground. */
class FanTrace
{
 public:
  FanTrace(const FanScene& scene, UnitMap& map);

  /** `beams` by growing slope, from the origin (m from the region's corner and the zero of
   * heights). */
  void trace(
      const Eigen::Vector3f& origin,
      const BeamFans& fans,
      int32_t fan,
      std::span<const FanBeam> beams);

 private:
  /** Ditches are sought in every second fan, for two. */
  static constexpr int32_t kFansPerDitch = 2;

  /** The lowest beam that passes, and how high the beams above it follow without a gap. */
  struct Pass
  {
    float from_m = 0;
    float to_m = 0;
    float slope = 0;
    float top_slope = 0;
  };

  /** Heights over the ground at which a beam frees cells: below most_m, and above a little less
   * than nothing, by the ground reference's own error and that of the sensor's tilt. */
  struct Low
  {
    float most_m = 0;
    float sunk_m = 0;
    float sunk_per_m = 0;

    bool holds(float height_m, float along_m) const
    {
      return (height_m < most_m) & (height_m > -(sunk_m + sunk_per_m * along_m));
    }
  };

  float neededFrom(const BeamFans& fans) const;
  float lowFrom(const GroundWay& way, const Pass& pass) const;
  void follow(const BeamFans& fans, const Pass& pass);
  void spreadWays(const BeamFans& fans, size_t count);
  void freeAlong(const GroundWay& way, const Pass& pass);
  float topSlope(std::span<const FanBeam> beams, size_t k, float to_m) const;

  /** Where a beam met the ground, and how that came there; heights from the sensor. */
  struct Landing
  {
    float reach_m = 0;
    float z_m = 0;
    float slope = 0;
    float from_m = 0;  //!< an earlier landing, for the slope of the next
    float from_z_m = 0;
    bool is_ground = false;
  };

  void findDitches(const BeamFans& fans, std::span<const FanBeam> beams);
  Landing after(const Landing& before, const FanBeam& beam, bool is_ground) const;
  float heightOver(const GroundWay& way, float slope, float along_m) const;
  void level(const GroundWay& way, float over_m, Landing& landing) const;
  void sink(
      const BeamFans& fans, const Landing& before, std::span<const FanBeam> beams, float sunk_m);
  bool isDitch(
      const Landing& before, std::span<const FanBeam> beams, float sunk_m, float edge_m) const;
  void markFloor(const GroundWay& way, const Landing& brink, const FanBeam& beam);
  void markNegative(const GroundWay& way, float from_m, float to_m);

  GroundWay wayTo(const Direction& to) const
  {
    return {{origin_.x(), origin_.y(), to}, cell_m_, edge_};
  }

  UnitCell& cellAt(const GroundRay::Place& place) const
  {
    return cells_.at({scene_.region.min.x + place.x, scene_.region.min.y + place.y});
  }

  static constexpr size_t kMostWays = 16;

  const FanScene& scene_;
  layers::WrappedGrid<UnitCell>::View cells_;
  LocalGround::View ground_;
  float cell_m_;
  int32_t edge_;
  Low low_;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
  int32_t fan_ = 0;
  std::array<GroundWay, kMostWays> ways_;  // side by side, as many as the last pass was wide
  size_t count_ = 0;
};
}  // namespace traverse::multi_lidar_grid
