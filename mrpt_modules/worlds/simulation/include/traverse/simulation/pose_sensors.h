// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/geometry/pose2.h>
#include <traverse/options/option.h>
#include <traverse/poses/pose_track.h>
#include <traverse/simulation/motion.h>
#include <traverse/simulation/random.h>

#include <string>
#include <vector>

namespace traverse::simulation
{
/** Section [Ins]: satellite and inertial navigation that says where the vehicle is on the map. */
struct InsParams
{
  std::string label = "INS";
  double rate_hz = 50;
  double noise_xy_m = 0.01;
  double noise_z_m = 0.02;
  double noise_deg = 0.02;
  double clock_offset_s = 0;
  double late_s = 0;
  double drop_out = 0;
  double dead_after_s = 0;

  friend bool operator==(const InsParams&, const InsParams&) = default;
};

template <class P, class F>
void visitInsParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"label", "name of the sensor in the log"}, p.label);
  f(Option{"rate_hz", "poses a second; 0: there is none", {0, 1000}}, p.rate_hz);
  f(Option{"noise_xy_m", "standard deviation of x and of y, m", {0, 100}}, p.noise_xy_m);
  f(Option{"noise_z_m", "standard deviation of the height, m", {0, 100}}, p.noise_z_m);
  f(Option{"noise_deg", "standard deviation of the turn about each axis, deg", {0, 90}},
    p.noise_deg);
  f(Option{"clock_offset_s", "its clock is ahead by so much, s", {-3600, 3600}}, p.clock_offset_s);
  f(Option{"late_s", "its poses arrive so late, s", {0, 3600}}, p.late_s);
  f(Option{"drop_out", "share of the poses that are lost, 0..1", {0, 1}}, p.drop_out);
  f(Option{"dead_after_s", "it is silent from then on, s of the recording; 0: never", {0, 3600}},
    p.dead_after_s);
}

template <class F>
void visit(InsParams& p, F&& f)
{
  visitInsParams(p, f);
}

template <class F>
void visit(const InsParams& p, F&& f)
{
  visitInsParams(p, f);
}

/** Section [Odometry]: what the wheels tell. */
struct OdometryParams
{
  std::string label = "ODOMETRY";
  double rate_hz = 20;
  double scale_error = 0.01;
  double yaw_drift_degpm = 0.02;
  double noise_share = 0.01;
  double noise_degpm = 0.05;
  double clock_offset_s = 0;

  friend bool operator==(const OdometryParams&, const OdometryParams&) = default;
};

template <class P, class F>
void visitOdometryParams(P& p, F&& f)
{
  using options::Option;
  f(Option{"label", "name of the sensor in the log"}, p.label);
  f(Option{"rate_hz", "poses a second; 0: there is none", {0, 1000}}, p.rate_hz);
  f(Option{"scale_error", "share by which it takes the way for longer than it is", {-0.5, 0.5}},
    p.scale_error);
  f(Option{"yaw_drift_degpm", "its heading turns away by so much on a metre, deg/m", {-10, 10}},
    p.yaw_drift_degpm);
  f(Option{"noise_share", "standard deviation of a metre's way, m; grows with its root", {0, 1}},
    p.noise_share);
  f(
      Option{
          "noise_degpm",
          "standard deviation of the heading over a metre, deg; grows with its root",
          {0, 10}},
      p.noise_degpm);
  f(Option{"clock_offset_s", "its clock is ahead by so much, s", {-3600, 3600}}, p.clock_offset_s);
}

template <class F>
void visit(OdometryParams& p, F&& f)
{
  visitOdometryParams(p, f);
}

template <class F>
void visit(const OdometryParams& p, F&& f)
{
  visitOdometryParams(p, f);
}

/** What an INS says. */
struct InsPose
{
  poses::TimeNs stamp = 0;    //!< by its own clock
  poses::TimeNs arrival = 0;  //!< true time
  std::string label;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
};

/** What odometry says: a pose in the plane, in a frame of its own that begins where the vehicle
 * does. */
struct OdometryPose
{
  poses::TimeNs stamp = 0;
  poses::TimeNs arrival = 0;
  std::string label;
  double x_m = 0;
  double y_m = 0;
  double yaw_rad = 0;  //!< -pi..pi
};

/** Pose k depends on the drive, the parameters, the seed and k only. */
class Ins
{
 public:
  /** Throws options::OptionError. */
  Ins(const InsParams& params, uint64_t seed);

  /** How many poses there are by a time of the recording, s; lost ones included. */
  uint64_t posesUntil(double end_s) const;

  poses::TimeNs arrivalOf(uint64_t k) const;

  bool isLost(uint64_t k) const;

  InsPose pose(uint64_t k, const Motion& drive) const;

 private:
  InsParams params_;
  uint64_t seed_;
};

/** Adds up what odometry tells of each step. */
class DeadReckoning
{
 public:
  /** Throws options::OptionError. */
  DeadReckoning(const OdometryParams& params, uint64_t seed);

  /** As the wheels moved, without error. */
  void step(const geometry::Pose2& from, const geometry::Pose2& to);

  /** From where it began. */
  const geometry::Pose2& at() const { return at_; }

 private:
  OdometryParams params_;
  Random random_;
  geometry::Pose2 at_;
};

/** Errors add up along the way, so the poses of a drive are made at once. */
std::vector<OdometryPose> odometryOf(
    const Motion& drive, double end_s, const OdometryParams& params, uint64_t seed);
}  // namespace traverse::simulation
