// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/points/deskew.h>

#include <cmath>
#include <map>
#include <optional>

namespace traverse::points
{
namespace
{
/** Motion of the vehicle frame from its place at stamp + time to its place at stamp. One look-up
 * per millisecond slot, interpolated between: over 1 ms a vehicle at 60 m/s and 720 deg/s strays
 * less than 0.1 mm from the straight line between two poses. */
class MotionTable
{
 public:
  MotionTable(const poses::PoseTrack& track, TimeNs stamp, const poses::TrackedPose& reference) :
      track_(track),
      stamp_(stamp),
      segment_(reference.segment),
      T_base_map_(reference.T_map_base.inverse())
  {
  }

  std::optional<Eigen::Isometry3f> at(float time_s)
  {
    const bool plausible = std::abs(time_s) < kLongest_s;  // false for NaN
    if (!plausible)
    {
      return std::nullopt;
    }
    const int64_t slot = std::llround(std::floor(static_cast<double>(time_s) / kSlot_s));
    if (from_ == nullptr || slot != slot_)
    {
      slot_ = slot;
      from_ = &knot(slot);
      to_ = &knot(slot + 1);
    }
    if (!*from_ || !*to_)
    {
      return std::nullopt;
    }
    const double fraction = static_cast<double>(time_s) / kSlot_s - static_cast<double>(slot);
    Eigen::Isometry3f blend = Eigen::Isometry3f::Identity();
    blend.matrix() =
        ((1 - fraction) * (*from_)->matrix() + fraction * (*to_)->matrix()).cast<float>();
    return blend;
  }

 private:
  static constexpr double kSlot_s = 1e-3;
  static constexpr float kLongest_s = 3600;

  const std::optional<Eigen::Isometry3d>& knot(int64_t slot)
  {
    const auto [entry, is_new] = knots_.try_emplace(slot);
    if (is_new)
    {
      const auto pose = track_.at(stamp_ + slot * 1'000'000);
      if (pose && pose->segment == segment_)
      {
        entry->second = T_base_map_ * pose->T_map_base;
      }
    }
    return entry->second;
  }

  const poses::PoseTrack& track_;
  TimeNs stamp_;
  int segment_;
  Eigen::Isometry3d T_base_map_;
  std::map<int64_t, std::optional<Eigen::Isometry3d>> knots_;  // stay where they are
  int64_t slot_ = 0;                                           // of the last point
  const std::optional<Eigen::Isometry3d>* from_ = nullptr;
  const std::optional<Eigen::Isometry3d>* to_ = nullptr;
};
}  // namespace

Deskew deskew(ScanBuffer& scan, const poses::PoseTrack& track)
{
  if (scan.time_s.empty() || !track.moves())
  {
    return Deskew::not_needed;
  }
  const auto reference = track.at(scan.stamp);
  if (!reference)
  {
    return Deskew::no_poses;
  }
  MotionTable motion(track, scan.stamp, *reference);
  ScanBuffer moved;
  moved.x.resize(scan.size());
  moved.y.resize(scan.size());
  moved.z.resize(scan.size());
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const auto T = motion.at(scan.time_s[i]);
    if (!T)
    {
      return Deskew::no_poses;
    }
    const Eigen::Vector3f p = *T * Eigen::Vector3f(scan.x[i], scan.y[i], scan.z[i]);
    moved.x[i] = p.x();
    moved.y[i] = p.y();
    moved.z[i] = p.z();
  }
  scan.x.swap(moved.x);
  scan.y.swap(moved.y);
  scan.z.swap(moved.z);
  return Deskew::corrected;
}
}  // namespace traverse::points
