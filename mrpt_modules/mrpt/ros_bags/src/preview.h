// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_stream.h"
#include "notes.h"
#include "transform_tree.h"

#include <map>
#include <set>
#include <string>

namespace traverse::ros_bags
{
/** What has to be known of a whole bag before its first message can become an observation. */
struct Preview
{
  TransformTree tree;
  std::string base;                           //!< the vehicle's frame; "" where there is none
  std::map<std::string, CameraInfo> cameras;  //!< by topic, the first of each
  std::set<std::string> spatial;  //!< topics of odometry that a pose in the plane would cut
};

/** A pass over the bag. Throws importing::ImportError where it cannot be opened. */
Preview readPreview(
    const std::filesystem::path& file,
    const BagParams& params,
    const std::atomic<bool>* stop,
    Notes& notes);

/** Moves in the x-y plane only, to 1 um and 0.05 mrad: what odometry of wheels says. */
bool isPlanar(const Eigen::Isometry3d& pose);
}  // namespace traverse::ros_bags
