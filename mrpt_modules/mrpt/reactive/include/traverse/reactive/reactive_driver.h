// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/drivetrain.h>
#include <traverse/geometry/pose2.h>
#include <traverse/geometry/vehicle.h>
#include <traverse/options/option.h>
#include <traverse/poses/pose_track.h>

#include <Eigen/Core>

#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace traverse::reactive
{
/** Which of MRPT's reactive navigators. */
enum class Navigator : uint8_t
{
  flat,    //!< "2d": CReactiveNavigationSystem
  levels,  //!< "3d": CReactiveNavigationSystem3D, the vehicle as a pile of two prisms
};

/** Section [Reactive]. */
struct ReactiveParams
{
  Navigator navigator = Navigator::flat;
  double reference_distance_m = 6;
  int paths = 121;
  double grid_resolution_m = 0.05;
  double waypoint_spacing_m = 1.0;
  double waypoint_tolerance_m = 0.5;
  double goal_tolerance_m = 0.3;

  friend bool operator==(const ReactiveParams&, const ReactiveParams&) = default;
};

template <class P, class F>
requires std::same_as<std::remove_const_t<P>, ReactiveParams>

void visit(P& p, F&& f)
{
  using options::Option;
  f(Option{"navigator", "MRPT's CReactiveNavigationSystem (2d) or ...3D (3d)"}, p.navigator);
  f(Option{"reference_distance_m", "how far its trajectories look, m", {0.5, 100}},
    p.reference_distance_m);
  f(Option{"paths", "trajectories of a family", {11, 1001}}, p.paths);
  f(Option{"grid_resolution_m", "of its collision grids, m", {0.01, 1}}, p.grid_resolution_m);
  f(Option{"waypoint_spacing_m", "between the points of a path that it is given, m", {0.1, 20}},
    p.waypoint_spacing_m);
  f(Option{"waypoint_tolerance_m", "so near one of them is passed, m", {0.05, 20}},
    p.waypoint_tolerance_m);
  f(Option{"goal_tolerance_m", "so near the last of them is reached, m", {0.05, 20}},
    p.goal_tolerance_m);
}

/** What the driver senses in a control step. */
struct Senses
{
  poses::TimeNs now = 0;
  geometry::Pose2 pose;
  geometry::Twist2 motion;                 //!< as it drives now
  std::vector<Eigen::Vector3f> obstacles;  //!< points of the vehicle frame, z over the ground, m
  double speed_limit_mps = 0;              //!< commands are slowed down to it along the same arc
};

/** What comes of a control step. */
enum class Outcome : uint8_t
{
  driving,
  no_motion,  //!< it finds none: the command is to stand
  arrived,    //!< at the last point of what it follows
  failed,     //!< MRPT's navigator gave up or threw; text says why
  idle,       //!< there is nothing to follow
};

struct Command
{
  geometry::Twist2 twist;
  Outcome outcome = Outcome::idle;
  std::string text;
};

/** MRPT's reactive navigator behind a CRobot2NavInterface of ours, which senses nothing but what a
 * step is given. MRPT's clock is the simulated one while a step runs. What MRPT 2.5.8 does wrong is
 * put right here, and nowhere else: errors that it forgets (NAV_ERROR is overwritten at the end of
 * a step), exceptions that it swallows, targets that no trajectory reaches in the first step, steps
 * within 20 ms that it skips, its table of times on stdout, obstacles below 1 cm that ...3D
 * ignores.
 *
 * Not for use by two threads at once: MRPT's clock is one per process. */
class ReactiveDriver
{
 public:
  /** Collision grids are computed (seconds) or read from `cache`, a folder that is made where it is
   * missing. With a log_folder, .reactivenavlog files are written there. Throws
   * options::OptionError, std::runtime_error with MRPT's words. */
  ReactiveDriver(
      const geometry::Vehicle& vehicle,
      const geometry::Drivetrain& drivetrain,
      const ReactiveParams& params,
      const std::filesystem::path& cache,
      const std::filesystem::path& log_folder = {});
  ~ReactiveDriver();
  ReactiveDriver(ReactiveDriver&&) noexcept;
  ReactiveDriver& operator=(ReactiveDriver&&) noexcept;

  /** Places of the map frame, from the one next to the vehicle to the last. Replaces what it
   * followed; empty: nothing, the vehicle stands. */
  void follow(const std::vector<Eigen::Vector2d>& places);

  Command step(const Senses& senses);

  /** The ini that MRPT's navigator was given. */
  const std::string& navigatorIni() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};
}  // namespace traverse::reactive

template <>
struct traverse::options::EnumNames<traverse::reactive::Navigator>
{
  using E = traverse::reactive::Navigator;
  static constexpr std::array<std::pair<E, std::string_view>, 2> kNames = {
      {{E::flat, "2d"}, {E::levels, "3d"}}};
};
