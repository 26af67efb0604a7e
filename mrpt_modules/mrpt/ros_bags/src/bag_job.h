// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bag_wire.h"

#include <set>
#include <string>

namespace traverse::ros_bags
{
/** What a pass over a bag wants. */
struct BagSelection
{
  std::set<std::string> types;   //!< whose bytes are sent
  std::set<std::string> topics;  //!< empty: all
  bool name_others = true;       //!< tell of each message that is not sent
  uint64_t first = 0;            //!< message to begin with, in the order of recording
};

/** What runs in the child, the only place that knows ROS's library: sends the messages of a bag, in
 * the order of recording. Never throws for what stands in the bag. */
void runBagJob(
    int bag_fd, int frames_fd, sandbox::SharedProgress& progress, const BagSelection& want);
}  // namespace traverse::ros_bags
