// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/geometry/exact_trig.h>
#include <traverse/navigation/on_path.h>
#include <traverse/navigation/track_path.h>

#include <algorithm>
#include <cmath>

namespace traverse::navigation
{
namespace
{
constexpr double kFarthestOff_m = 0.6;
constexpr double kFarthestOff_rad = geometry::kPi / 3;

/** Errors fade over about twice this way, in wheelbases. */
constexpr double kFade = 0.7;

/** Larger ones lead back to the path at the angle of this one. */
constexpr double kSteepest_m = 0.3;

/** From a command to the wheels. */
constexpr double kDelay_s = 0.05;

/** The curvature to steer now, 1/m: that of the path here, or beyond a place ahead by which the
 * wheels must be half-way from the one to the other. */
double curvatureAhead(
    std::span<const PathPoint> piece,
    const OnPath& here,
    double speed_mps,
    const geometry::Drivetrain& drivetrain)
{
  const auto steer_rad = [&](double curvature_1pm)
  { return geometry::angleOf(curvature_1pm * drivetrain.wheelbase_m, 1); };
  const double rate_radps = drivetrain.max_steer_rate_degps * geometry::kPi / 180;
  const double longest_s = kDelay_s + drivetrain.max_steer_deg * geometry::kPi / 180 / rate_radps;
  double curvature = piece[here.next == 0 ? 0 : here.next - 1].curvature_1pm;
  for (size_t k = here.next; k + 1 < piece.size(); ++k)
  {
    const double away_m = piece[k].along_m - here.along_m;
    if (away_m > speed_mps * longest_s)
    {
      break;
    }
    const double change_rad = std::abs(steer_rad(piece[k].curvature_1pm) - steer_rad(curvature));
    if (change_rad > 0 && away_m <= speed_mps * (kDelay_s + change_rad / (2 * rate_radps)))
    {
      curvature = piece[k].curvature_1pm;
    }
  }
  return curvature;
}

/** The path's heading where the vehicle is. */
double yawAt(std::span<const PathPoint> piece, const OnPath& here)
{
  const size_t k = here.next == 0 ? 0 : here.next - 1;
  const double way_m = here.along_m - piece[k].along_m;
  const double side = piece[k].is_backward ? -1 : 1;
  return piece[k].pose.yaw_rad + side * piece[k].curvature_1pm * way_m;
}
}  // namespace

std::optional<geometry::Twist2> trackPath(
    std::span<const PathPoint> piece,
    const geometry::Pose2& pose,
    double speed_mps,
    const geometry::Drivetrain& drivetrain)
{
  const OnPath here = nearestOn(piece, {pose.x_m, pose.y_m});
  if (piece.size() < 2 || !(here.off_m <= kFarthestOff_m))
  {
    return std::nullopt;
  }
  const double yaw_rad = yawAt(piece, here);
  const double turned_rad = std::remainder(pose.yaw_rad - yaw_rad, 2 * geometry::kPi);
  if (!(std::abs(turned_rad) <= kFarthestOff_rad))
  {
    return std::nullopt;
  }
  const geometry::SinCos yaw = geometry::sinCosOfAny(yaw_rad);
  const double left_m =
      (pose.y_m - here.nearest.y_m) * yaw.cos - (pose.x_m - here.nearest.x_m) * yaw.sin;
  const double side = piece.front().is_backward ? -1 : 1;
  const double fade_m = kFade * drivetrain.wheelbase_m;
  const double back = 2 * side * turned_rad / fade_m +
                      std::clamp(left_m, -kSteepest_m, kSteepest_m) / (fade_m * fade_m);
  const double radius_m = geometry::minTurningRadius_m(drivetrain);
  const double most = radius_m > 0 ? 1 / radius_m : std::numeric_limits<double>::infinity();
  const double curvature =
      std::clamp(curvatureAhead(piece, here, speed_mps, drivetrain) - back, -most, most);
  return geometry::Twist2{side * speed_mps, side * speed_mps * curvature};
}
}  // namespace traverse::navigation
