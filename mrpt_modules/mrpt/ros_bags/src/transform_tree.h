// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "messages.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace traverse::ros_bags
{
/** The frames of a recording, each with its pose in its parent over time. */
class TransformTree
{
 public:
  /** Of a message on /tf_static if `fixed`. Repetitions take no memory; beyond a few million
   * samples or a few thousand frames (a hostile recording) nothing more is taken. */
  void add(const Transform& transform, bool fixed);

  bool has(const std::string& frame) const;

  /** Pose of `frame` in `base` by each joint's latest sample up to then (before its first: the
   * first one); nothing where no chain of frames joins them. */
  std::optional<Eigen::Isometry3d> find(
      const std::string& base, const std::string& frame, int64_t stamp_ns) const;

  bool full() const { return full_; }

  bool empty() const { return joints_.empty(); }

 private:
  struct Sample
  {
    int64_t stamp_ns = 0;
    std::string parent;
    Eigen::Isometry3d T_parent_child = Eigen::Isometry3d::Identity();
  };

  struct Joint
  {
    bool fixed = false;
    std::vector<Sample> samples;  // by stamp
  };

  /** A frame above another one. */
  struct Step
  {
    std::string frame;
    Eigen::Isometry3d T_frame_start = Eigen::Isometry3d::Identity();
  };

  static void insert(Joint& joint, Sample sample);
  static const Sample& at(const Joint& joint, int64_t stamp_ns);
  std::vector<Step> climb(const std::string& frame, int64_t stamp_ns) const;

  std::map<std::string, Joint> joints_;  // by child
  size_t samples_ = 0;
  bool full_ = false;
};

/** The vehicle's frame: the first well-known name that the tree has; "" where it has none. */
std::string likelyBase(const TransformTree& tree);
}  // namespace traverse::ros_bags
