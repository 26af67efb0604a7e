// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/poses/pose_track.h>

#include <cstddef>
#include <span>
#include <vector>

namespace traverse::evaluation
{
/** A found pose and the true one at its time. */
struct PosePair
{
  poses::TimeNs time = 0;
  Eigen::Isometry3d found = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
};

struct PosePairs
{
  std::vector<PosePair> pairs;  //!< by time
  size_t without_truth = 0;     //!< found poses at times that truth does not span
};

/** Each found pose with the true one interpolated at its time; both in any order. */
PosePairs associate(
    const std::vector<poses::StampedPose>& found, const std::vector<poses::StampedPose>& truth);

/** Root mean square error of positions over a whole trajectory, m; NaN for none. */
struct AbsoluteError
{
  double rmse_m = 0;         //!< after the best rigid motion (Umeyama, 1991, no scale)
  double max_m = 0;          //!< after the same
  double from_start_m = 0;   //!< root mean square, first poses laid together
  double as_they_are_m = 0;  //!< root mean square, in one map frame
};

AbsoluteError absoluteError(std::span<const PosePair> pairs);

/** Error of a piece of the way of this length; NaN where the way is shorter. */
struct RelativeError
{
  double distance_m = 0;
  size_t pieces = 0;
  double translation_percent = 0;  //!< mean, of the piece's length
  double rotation_deg_per_m = 0;   //!< mean
};

/** For each distance: over all pieces of the true way that begin at a pose and end at the first one
 * at least so far along the way. Distances that are not above 0 give NaN. */
std::vector<RelativeError> relativeErrors(
    std::span<const PosePair> pairs, const std::vector<double>& distances_m);

/** Mean errors of the steps from pose to pose: of translation, in percent of the mean step, and of
 * rotation, per metre. distance_m is the mean step; NaN for fewer than two poses or no way. */
RelativeError stepError(std::span<const PosePair> pairs);
}  // namespace traverse::evaluation
