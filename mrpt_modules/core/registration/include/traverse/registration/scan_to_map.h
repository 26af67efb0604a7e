// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/points/scan.h>
#include <traverse/poses/pose_track.h>
#include <traverse/registration/local_map.h>

#include <Eigen/Geometry>

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace traverse::registration
{
/** How scans are matched. Lengths that are not here are multiples of the voxel. */
struct Params
{
  double voxel_m = 0;         //!< edge of the map's voxels; 0: a 30th of what 9 of 10 points of the
                              //!< first scan lie within, at least 5 cm and at most 1 m
  double max_range_m = 100;   //!< further points are left out, and the map is forgotten there
  poses::TrackLimits limits;  //!< a pose that these call a jump is none
};

/** What became of a scan. */
enum class Verdict : uint8_t
{
  tracked,         //!< it has a pose
  waiting,         //!< the first scan: its pose comes with the next one's
  too_few_points,  //!< within range, one per voxel
  little_overlap,  //!< too few of them near the map
  featureless,     //!< the map leaves a direction of motion open, as a long plain corridor does
  unsettled,       //!< the iterations did not come to rest
  jump,            //!< further than the vehicle can have moved
};

inline constexpr std::array<std::string_view, 7> kVerdictNames = {
    "tracked",
    "no second scan follows it",
    "it has too few points within range",
    "it overlaps too little with the map",
    "its surroundings leave a direction of motion open",
    "matching it does not come to rest",
    "its match would be a jump that the vehicle cannot make"};

/** A scan's pose, or why it has none. */
struct Matched
{
  Verdict verdict = Verdict::tracked;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();  //!< of a tracked one, at its stamp
  int iterations = 0;
  /** The second scan's only: of the first, which lies at the origin. */
  std::optional<poses::StampedPose> first;
};

/** The vehicle's way, told from its scans alone: each is matched to a map of those before it.
 *
 * The steps are KISS-ICP's (Vizzo, Guadagnino, Mersch, Wiesmann, Behley, Stachniss: "KISS-ICP: In
 * Defense of Point-to-Point ICP", RA-L 2023, arXiv 2209.15397; sections and equations are cited in
 * the code), but pairs are points and planes, a scan whose motion was badly predicted is deskewed
 * once more with the motion found, and the first two scans' motion is told together. The map's
 * origin is the vehicle at the first scan that the next one matches. A scan without a pose leaves
 * the map as it was. The same bits on every processor: no libm. */
class ScanToMap
{
 public:
  /** Throws std::invalid_argument for lengths that are none. */
  explicit ScanToMap(const Params& params);

  /** `scan` as decoded, before deskew(). Any content. */
  Matched take(points::ScanBuffer scan);

  const LocalMap* map() const { return map_ ? &*map_ : nullptr; }

 private:
  Matched start(points::ScanBuffer scan);
  Matched follow(const points::ScanBuffer& scan);
  std::vector<Eigen::Vector3d> stillPoints(
      points::ScanBuffer scan, const poses::PoseTrack& track) const;
  void mapFirst(const poses::PoseTrack& track);
  void match(std::span<const Eigen::Vector3d> points, points::TimeNs stamp, Matched& result);
  void adapt(const Eigen::Isometry3d& predicted, const Eigen::Isometry3d& found);
  void keep(const std::vector<Eigen::Vector3d>& points, const poses::StampedPose& pose);
  poses::PoseTrack trackWith(const std::optional<poses::StampedPose>& newest) const;
  bool isJump(const poses::StampedPose& pose) const;
  double voxel_m() const;
  double deviation_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) const;
  double sigma_m() const;

  Params params_;
  std::optional<LocalMap> map_;
  std::optional<points::ScanBuffer> first_;  // until the second one's match tells its motion
  std::vector<poses::StampedPose> last_;     // of the last max_pose_age_s, by time
  double deviation_squares_m2_ = 0;
  int deviations_ = 0;
};
}  // namespace traverse::registration
