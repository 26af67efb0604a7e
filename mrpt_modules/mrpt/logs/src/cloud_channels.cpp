// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_channels.h"

#include <mrpt/maps/CPointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fcntl.h>
#include <map>
#include <system_error>

namespace traverse::logs
{
namespace
{
using formats::ChannelsReader;

/** Rings as a Scan numbers them, 0 = lowest, by the mean slope of their points: recordings count
 * from below, from above, or in the order in which lasers fire. */
void sortByElevation(points::ScanBuffer& scan)
{
  struct Sum
  {
    double slope = 0;
    double points = 0;
  };

  const Eigen::Isometry3d T_sensor_base = scan.T_base_sensor.inverse();
  std::map<uint16_t, Sum> sums;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    const Eigen::Vector3d p = T_sensor_base * Eigen::Vector3d(scan.x[i], scan.y[i], scan.z[i]);
    Sum& sum = sums[scan.ring[i]];
    sum.slope += p.z() / std::max(1e-3, p.head<2>().norm());
    sum.points += 1;
  }
  std::vector<std::pair<double, uint16_t>> order;
  order.reserve(sums.size());
  for (const auto& [ring, sum] : sums)
  {
    order.emplace_back(sum.slope / sum.points, ring);
  }
  std::sort(order.begin(), order.end());
  std::map<uint16_t, uint16_t> rank;
  for (const auto& [slope, ring] : order)
  {
    rank[ring] = static_cast<uint16_t>(rank.size());
  }
  for (uint16_t& ring : scan.ring)
  {
    ring = rank[ring];
  }
}

/** The values of the points that were kept. */
template <class T>
std::vector<T> select(const std::vector<T>& all, const points::ScanBuffer& scan)
{
  if (scan.input_index.empty() || all.empty())
  {
    return all;
  }
  std::vector<T> some;
  some.reserve(scan.size());
  for (const uint32_t i : scan.input_index)
  {
    some.push_back(all.at(i));
  }
  return some;
}

std::string inWords(ChannelsReader::Found found)
{
  switch (found)
  {
    case ChannelsReader::Found::yes:
      return "attached";
    case ChannelsReader::Found::none:
      return "the side file has none for the cloud";
    case ChannelsReader::Found::another:
      return "the side file's are of another cloud";
    case ChannelsReader::Found::damaged:
      return "the side file's are damaged";
  }
  return "?";
}
}  // namespace

CloudChannels::CloudChannels(const std::filesystem::path& log)
{
  const std::filesystem::path file = formats::channelsFileOf(log);
  fd_ = sandbox::Fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd_.get() < 0)
  {
    const int code = errno;
    damage_ = code == ENOENT ? "" : file.string() + ": " + std::generic_category().message(code);
    return;
  }
  reader_.emplace(fd_.get());
  damage_ = reader_->damage().empty() ? "" : file.string() + " " + reader_->damage();
}

std::string CloudChannels::attach(
    const mrpt::obs::CObservation& observation, points::ScanBuffer& scan) const
{
  const auto* cloud = dynamic_cast<const mrpt::obs::CObservationPointCloud*>(&observation);
  if (!reader_ || cloud == nullptr || !cloud->pointcloud)
  {
    return "";
  }
  const auto& x = cloud->pointcloud->getPointsBufferRef_x();
  const auto& y = cloud->pointcloud->getPointsBufferRef_y();
  const auto& z = cloud->pointcloud->getPointsBufferRef_z();
  const size_t used = scan.input_index.empty() ? scan.size() : scan.input_points;
  const ChannelsReader::Answer answer = reader_->find(
      {cloud->sensorLabel, scan.stamp, static_cast<uint32_t>(x.size()),
       formats::cloudChecksum({x.data(), x.size()}, {y.data(), y.size()}, {z.data(), z.size()})});
  if (answer.found == ChannelsReader::Found::yes && used == x.size())
  {
    scan.time_s = select(answer.channels.time_s, scan);
    scan.ring = select(answer.channels.ring, scan);
    if (!scan.ring.empty())
    {
      sortByElevation(scan);
    }
  }
  return inWords(answer.found);
}
}  // namespace traverse::logs
