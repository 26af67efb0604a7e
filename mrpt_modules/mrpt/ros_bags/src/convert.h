// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reorder.h"
#include "surroundings.h"

#include <mrpt/obs/CObservation.h>

#include <memory>

// A message of each kind as an observation, without its label and stamp. Each throws
// formats::FormatError where the message makes no sense.
namespace traverse::ros_bags
{
importing::Entry fromCloud(const PointCloud& cloud, const Origin& origin, Surroundings& around);
importing::Entry fromLaser(const LaserScan& scan, const Origin& origin, Surroundings& around);
importing::Entry fromImage(const Image& image, const Origin& origin, Surroundings& around);
importing::Entry fromOdometry(const Odometry& odometry, const Origin& origin, Surroundings& around);
importing::Entry fromImu(const Imu& imu, const Origin& origin, Surroundings& around);
importing::Entry fromFix(const NavSatFix& fix, const Origin& origin, Surroundings& around);
importing::Entry fromVelodyne(
    const VelodynePackets& packets, const Origin& origin, Surroundings& around);

/** Puts colour images into the depth images of the same stamp: of the same frame if there is one,
 * else of the most similar topic. A colour image that was used is taken out of the group. */
void joinColour(std::vector<Pending>& same_stamp);
}  // namespace traverse::ros_bags
