// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "message_bytes.h"

#include <cmath>

namespace traverse::ros_bags
{
int64_t MessageBytes::time()
{
  constexpr int64_t kNsPerS = 1'000'000'000;
  const int64_t s = u32();
  return s * kNsPerS + u32();
}

Header MessageBytes::header()
{
  Header header;
  u32();  // seq, which nobody fills reliably
  header.stamp_ns = time();
  header.frame = frame();
  return header;
}

std::string MessageBytes::frame()
{
  std::string name = text();
  return name.rfind('/', 0) == 0 ? name.substr(1) : name;
}

size_t MessageBytes::elements(size_t element_bytes)
{
  const size_t n = u32();
  if (n > remaining() / element_bytes)
  {
    fail("says it has " + std::to_string(n) + " elements, more than there are bytes for");
  }
  return n;
}

Eigen::Vector3d MessageBytes::vector()
{
  const double x = f64();
  const double y = f64();
  return {x, y, f64()};
}

std::optional<Eigen::Isometry3d> MessageBytes::motionIfAny()
{
  const Eigen::Vector3d shift = vector();
  const auto xyzw = fixed<double, 4>();
  Eigen::Quaterniond turn(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  constexpr double kFarthest_m = 1e9;
  constexpr double kFarFromUnit = 0.1;  // texts of few digits are met, not other lengths
  if (!shift.allFinite() || shift.cwiseAbs().maxCoeff() > kFarthest_m ||
      !(std::abs(turn.norm() - 1) < kFarFromUnit))
  {
    return std::nullopt;
  }
  turn.normalize();
  return Eigen::Isometry3d(Eigen::Translation3d(shift) * turn);
}

Eigen::Isometry3d MessageBytes::motion()
{
  const auto motion = motionIfAny();
  if (!motion)
  {
    fail("a pose that is none");
  }
  return *motion;
}
}  // namespace traverse::ros_bags
