// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace traverse::reactive
{
/** The places of a plan, and which of them is next. MRPT's navigators drive to each of them, back
 * too where they have missed one; here a place counts as passed where driving back makes no sense.
 */
class Places
{
 public:
  Places() = default;

  /** When a place counts as reached, or passed, m. */
  struct Limits
  {
    double turning_radius = 0;  //!< smallest of the vehicle
    double tolerance = 0;       //!< so near a place is reached
    double goal_tolerance = 0;  //!< likewise the last one
    double near = 0;            //!< what is further off is not passed
    double half_width = 0;      //!< with an obstacle nearer, a place near by is none
  };

  /** Throws std::invalid_argument where a place is not finite. */
  Places(std::vector<Eigen::Vector2d> places, const Limits& limits_m);

  bool empty() const { return places_.empty(); }

  size_t next() const { return next_; }

  size_t size() const { return places_.size(); }

  const Eigen::Vector2d& operator[](size_t n) const { return places_[n]; }

  /** Goes on to the next place that still lies before the vehicle, and that no obstacle (of the
   * vehicle's frame) stands on; the last one is never passed
   * so. Returns whether the next place is another one now. */
  bool goOn(const geometry::Pose2& pose, const std::vector<Eigen::Vector3f>& obstacles = {});

  /** Goes on to the next place whatever it is; false at the last one. */
  bool skip();

  void goBackTo(size_t next) { next_ = next; }

  /** Whether the last place is next, and reached. */
  bool isOver(const geometry::Pose2& pose) const;

 private:
  bool isPassed(size_t n, const geometry::Pose2& pose) const;
  bool isBlocked(
      size_t n, const geometry::Pose2& pose, const std::vector<Eigen::Vector3f>& obstacles) const;

  std::vector<Eigen::Vector2d> places_;
  size_t next_ = 0;
  Limits limits_m_;
};
}  // namespace traverse::reactive
