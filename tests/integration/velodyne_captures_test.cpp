// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Real captures decode to what such a sensor sees: all rings, a flat floor, a tenth of a second.
#include "support/data.h"
#include "support/simulated_velodyne.h"

#include <traverse/points/velodyne_scan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace traverse::testing
{
namespace
{
using points::Decoded;
using points::Reject;

constexpr auto kHdl32e = sensors::VelodyneModel::hdl32e;

class VelodyneCaptures : public ::testing::Test
{
 protected:
  void SetUp() override { TRAVERSE_NEEDS(sharedData("velodyne-pcap")); }

  static Capture captureOf(const std::string& name)
  {
    return captureInPcap(sharedData("velodyne-pcap/" + name));
  }
};

/** Distances of points from the plane z = ax + by + c that fits them best, metres, sorted. */
std::vector<double> distancesFromTheirPlane(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
  {
    const Eigen::Vector3d row(p.x(), p.y(), 1);
    normal += row * row.transpose();
    right += row * p.z();
  }
  const Eigen::Vector3d plane = normal.ldlt().solve(right);
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Eigen::Vector3d& p : points)
  {
    distances.push_back(std::abs(p.z() - plane.dot(Eigen::Vector3d(p.x(), p.y(), 1))));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

/** What the nine lowest lasers hit below the roof that the sensor stands on, on one side. */
std::vector<Eigen::Vector3d> groundBeside(const Decoded& out)
{
  std::vector<Eigen::Vector3d> ground;
  for (size_t i = 0; i < out.scan.size(); ++i)
  {
    const Eigen::Vector3d p(out.scan.x[i], out.scan.y[i], out.scan.z[i]);
    if (out.scan.ring[i] <= 8 && p.z() < -1.5 && p.y() > 0 && p.head<2>().norm() < 6)
    {
      ground.push_back(p);
    }
  }
  return ground;
}

void expectMonotoneTimesPerLaser(const Decoded& out)
{
  std::vector<float> last(32, -1);
  for (size_t i = 0; i < out.scan.size(); ++i)
  {
    ASSERT_GT(out.scan.time_s[i], last[out.scan.ring[i]]);
    last[out.scan.ring[i]] = out.scan.time_s[i];
  }
}

TEST_F(VelodyneCaptures, TheHdl32eSeesAFlatStreetWithAllItsRings)
{
  const Decoded out = decode(captureOf("sample_velodyne_hdl32.pcap"));
  EXPECT_EQ(out.rejects.of(Reject::bad_packet), 0U);
  std::set<uint16_t> rings(out.scan.ring.begin(), out.scan.ring.end());
  EXPECT_EQ(rings.size(), 31U) << "laser 11 of this very sensor returned nothing";
  rings.insert(sensors::ringsOf(sensors::factoryCalibration(kHdl32e), kHdl32e)[11]);
  EXPECT_EQ(rings.size(), 32U);
  const std::vector<double> off = distancesFromTheirPlane(groundBeside(out));
  ASSERT_GT(off.size(), 5000U);
  // The sensor's own noise is 2 cm; a street is not a plane.
  EXPECT_LT(off[off.size() / 2], 0.03);
  EXPECT_LT(off[off.size() * 9 / 10], 0.10);
  expectMonotoneTimesPerLaser(out);
}

TEST_F(VelodyneCaptures, TheVlp16HasItsRingsAndSkipsGpsPackets)
{
  const Capture capture = captureOf("sample_velodyne_vlp16_gps.pcap");
  EXPECT_EQ(capture.packets.size(), 293U);
  const Decoded out = decode(capture);
  EXPECT_EQ(out.scan.size(), capture.rawReturns());
  EXPECT_EQ(std::set<uint16_t>(out.scan.ring.begin(), out.scan.ring.end()).size(), 16U);
  EXPECT_EQ(*std::max_element(out.scan.ring.begin(), out.scan.ring.end()), 15);
  expectMonotoneTimesPerLaser(out);
}

TEST_F(VelodyneCaptures, PositionPacketsAreNoData)
{
  formats::PcapReader reader(sharedData("velodyne-pcap/sample_velodyne_vlp16_gps.pcap"));
  Capture all;
  while (const auto datagram = reader.next())
  {
    all.packets.emplace_back(datagram->payload.begin(), datagram->payload.end());
  }
  const Decoded out = decode(all);
  EXPECT_EQ(out.rejects.of(Reject::bad_packet), 57U);
  EXPECT_EQ(out.scan.size(), all.packets.empty() ? 0U : 73486U);
}

TEST_F(VelodyneCaptures, TheVlp32cImageIsHalfATurnOfItsField)
{
  const Decoded out = decode(captureOf("nebula_vlp32c_front.pcap.gz"));
  EXPECT_EQ(std::set<uint16_t>(out.scan.ring.begin(), out.scan.ring.end()).size(), 32U);
  EXPECT_EQ(out.image.rows, 32);
  // 180 degrees of 0.2 degrees each, then the sensor is silent.
  EXPECT_NEAR(out.image.columns, 905, 10);
  EXPECT_TRUE(out.image.closes);
}

TEST(VelodyneLog, IsATurnOfATenthOfASecond)
{
  const std::string file = mrptData("test_velodyne_VLP16.rawlog");
  TRAVERSE_NEEDS(file);
  const Decoded out = decode(captureInRawlog(file));
  const auto [first, last] = std::minmax_element(out.scan.time_s.begin(), out.scan.time_s.end());
  EXPECT_GE(*first, 0);
  // 75 packets of 1327.1 us, less what the last laser does not wait.
  EXPECT_NEAR(*last - *first, 75 * 1327.104e-6, 50e-6);
  EXPECT_FALSE(out.image.closes) << "2.5 degrees are missing";
  EXPECT_EQ(out.image.columns, 75 * 24);
  EXPECT_EQ(out.image.rows, 16);
  expectMonotoneTimesPerLaser(out);
}
}  // namespace
}  // namespace traverse::testing
