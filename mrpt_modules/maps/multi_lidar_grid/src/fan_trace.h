// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam_fans.h"
#include "cell_columns.h"
#include "ground_ray.h"
#include "ground_reference.h"
#include "rules.h"

#include <traverse/multi_lidar_grid/unit_map.h>

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
  FanTrace(const FanScene& scene, UnitMap& map) :
      scene_(scene),
      map_(map),
      cell_m_(scene.rules.cell_m()),
      edge_(scene.region.width()),
      side_m_(cell_m_ * static_cast<float>(edge_))
  {
  }

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

  float heightOver(const GroundRay& ray, float slope, float along_m) const;
  float neededFrom(const BeamFans& fans) const;
  float lowFrom(const GroundRay& ray, const Pass& pass) const;
  bool isLow(float height_m, float along_m) const;
  void follow(const BeamFans& fans, const Pass& pass);
  void followRay(const GroundRay& ray, const Pass& pass);
  void freeAlong(const GroundRay& ray, const Pass& pass);
  void free(const GroundRay::Place& place, float along_m, float ground_m, const Pass& pass);
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
  void level(const GroundRay& ray, float over_m, Landing& landing) const;
  void sink(
      const BeamFans& fans, const Landing& before, std::span<const FanBeam> beams, float sunk_m);
  bool isDitch(
      const Landing& before, std::span<const FanBeam> beams, float sunk_m, float edge_m) const;
  void markFloor(const GroundRay& ray, const Landing& brink, const FanBeam& beam);
  void markNegative(const GroundRay& ray, float from_m, float to_m);

  UnitCell& cellAt(const GroundRay::Place& place)
  {
    return map_.cells.at({scene_.region.min.x + place.x, scene_.region.min.y + place.y});
  }

  const FanScene& scene_;
  UnitMap& map_;
  float cell_m_;
  int32_t edge_;
  float side_m_;
  Eigen::Vector3f origin_ = Eigen::Vector3f::Zero();
  int32_t fan_ = 0;
};
}  // namespace traverse::multi_lidar_grid
