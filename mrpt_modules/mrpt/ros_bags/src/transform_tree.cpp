// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "transform_tree.h"

#include <algorithm>

namespace traverse::ros_bags
{
namespace
{
constexpr size_t kMostSamples = 2'000'000;
constexpr size_t kMostFrames = 4096;
constexpr std::ptrdiff_t kMostLate = 1000;
constexpr size_t kMostSteps = 64;  // up from a frame; more is a ring
}  // namespace

void TransformTree::add(const Transform& transform, bool fixed)
{
  if (transform.child.empty() || transform.child == transform.header.frame)
  {
    return;
  }
  const bool known = joints_.count(transform.child) > 0;
  if (samples_ >= kMostSamples || (!known && joints_.size() >= kMostFrames))
  {
    full_ = true;
    return;
  }
  Joint& joint = joints_[transform.child];
  Sample sample{transform.header.stamp_ns, transform.header.frame, transform.T_parent_child};
  if (fixed)
  {
    samples_ += joint.samples.empty() ? 1 : 0;
    joint.fixed = true;
    joint.samples.assign(1, std::move(sample));  // the last word holds for the whole recording
    return;
  }
  if (!joint.fixed)
  {
    const size_t before = joint.samples.size();
    insert(joint, std::move(sample));
    samples_ += joint.samples.size() - before;
  }
}

void TransformTree::insert(Joint& joint, Sample sample)
{
  const auto after = std::upper_bound(
      joint.samples.begin(), joint.samples.end(), sample.stamp_ns,
      [](int64_t stamp_ns, const Sample& s) { return stamp_ns < s.stamp_ns; });
  if (after != joint.samples.begin())
  {
    const Sample& before = *std::prev(after);
    // Fixed joints are often published again and again.
    if (before.parent == sample.parent &&
        before.T_parent_child.matrix() == sample.T_parent_child.matrix())
    {
      return;
    }
  }
  // Samples come late by a little; a recording that runs backwards must not take quadratic time.
  if (joint.samples.end() - after <= kMostLate)
  {
    joint.samples.insert(after, std::move(sample));
  }
}

const TransformTree::Sample& TransformTree::at(const Joint& joint, int64_t stamp_ns)
{
  const auto after = std::upper_bound(
      joint.samples.begin(), joint.samples.end(), stamp_ns,
      [](int64_t t, const Sample& s) { return t < s.stamp_ns; });
  return after == joint.samples.begin() ? *after : *std::prev(after);
}

bool TransformTree::has(const std::string& frame) const
{
  return joints_.count(frame) > 0 ||
         std::any_of(
             joints_.begin(), joints_.end(),
             [&](const auto& joint) { return joint.second.samples.front().parent == frame; });
}

std::vector<TransformTree::Step> TransformTree::climb(
    const std::string& frame, int64_t stamp_ns) const
{
  std::vector<Step> steps = {{frame, Eigen::Isometry3d::Identity()}};
  while (steps.size() < kMostSteps)
  {
    const auto joint = joints_.find(steps.back().frame);
    if (joint == joints_.end())
    {
      break;
    }
    const Sample& sample = at(joint->second, stamp_ns);
    steps.push_back({sample.parent, sample.T_parent_child * steps.back().T_frame_start});
  }
  return steps;
}

std::optional<Eigen::Isometry3d> TransformTree::find(
    const std::string& base, const std::string& frame, int64_t stamp_ns) const
{
  const std::vector<Step> from_base = climb(base, stamp_ns);
  for (const Step& up : climb(frame, stamp_ns))
  {
    const auto meet = std::find_if(
        from_base.begin(), from_base.end(), [&](const Step& s) { return s.frame == up.frame; });
    if (meet != from_base.end())
    {
      return meet->T_frame_start.inverse() * up.T_frame_start;
    }
  }
  return std::nullopt;
}

std::string likelyBase(const TransformTree& tree)
{
  for (const char* name :
       {"base_link", "base_footprint", "base", "vehicle", "ego_vehicle", "chassis", "robot", "body",
        "base_frame", "imu_link"})
  {
    if (tree.has(name))
    {
      return name;
    }
  }
  return "";
}
}  // namespace traverse::ros_bags
