// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/motion.h>

#include <memory>
#include <optional>
#include <vector>

namespace traverse::navigation
{
/** Shortest curves of a car-like vehicle where nothing stands in its way: Reeds and Shepp's, and
 * Dubins's, which are all forward (OMPL), or an arc and a straight line where any heading will do
 * at the end. OMPL uses libm: these curves may differ in their last bits between processors. */
class Curves
{
 public:
  Curves(double radius_m, bool drives_backward);
  ~Curves();
  Curves(Curves&&) noexcept;
  Curves& operator=(Curves&&) noexcept;

  /** Ways to a place, with a heading or with any; may be none. */
  std::vector<std::vector<Motion>> to(
      const Posed& from, Place place, std::optional<double> yaw_rad) const;

  /** No way to a place with that heading is shorter. */
  double least_m(const Posed& from, const geometry::Pose2& to) const;

 private:
  struct Spaces;

  void addArcAndLine(
      std::vector<std::vector<Motion>>& ways,
      const Posed& from,
      Place place,
      bool is_backward) const;

  double radius_m_;
  bool drives_backward_;
  std::unique_ptr<Spaces> spaces_;
};
}  // namespace traverse::navigation
