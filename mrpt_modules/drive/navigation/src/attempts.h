// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/navigation/costmap.h>

#include <vector>

namespace traverse::navigation
{
/** What is asked of a way. */
struct Attempt
{
  int32_t beside_strip = 0;  // soft cells so near to strips are open
  int32_t room = 0;          // strips with a hard cell so near are not
  bool is_wide = false;      // its outline has a margin
  int share = 1;             // of the expansions, one in so many
};

/** What is asked of ways, one after the other. */
class Attempts
{
 public:
  Attempts(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      bool is_hybrid,
      bool has_margin);

  /** Each asks less of a way than the one before. */
  std::vector<Attempt> in(const Costmap& costmap) const;

 private:
  bool is_hybrid_;
  bool has_margin_;
  double swing_m_;
};
}  // namespace traverse::navigation
