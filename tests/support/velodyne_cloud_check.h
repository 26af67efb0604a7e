// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data.h"
#include "recorded_cloud.h"

#include <traverse/points/velodyne_scan.h>
#include <traverse/sensors/velodyne_packet.h>
#include <traverse/sensors/velodyne_timing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace traverse::testing
{
// Our decoder against @foxglove/velodyne-cloud 1.0.1 on the same packets; how its output was
// recorded is in velodyne_cloud/README.md. No limits on either side, so both yield the same returns
// in the same order. Two known faults of that package are undone before comparing:
//  - it places every point of a block at the azimuth of the block's first firing (it computes the
//    azimuth of the firing, but uses it for its angle filter only). The manuals interpolate.
//  - its time tables are a translation from C++ that lost the integer divisions: VLP-16, where the
//    manual has 55.296 us x (laser / 16), it has 55.296 us x laser / 16 as a real number; VLP-32C
//    and HDL-32E likewise with laser / 2. (And the HDL-32E fires one laser per 1.152 us, not two.)
/** A capture, and what the package made of it. */
struct VelodyneCloudCase
{
  sensors::VelodyneModel model;
  std::filesystem::path packets;
  std::filesystem::path recorded;
};

/** Both decodings of one capture, and what tells a point's place in its packet. */
struct BothClouds
{
  sensors::VelodyneModel model;
  points::Decoded ours;
  RecordedCloud theirs;
  std::vector<size_t> record;    // of each of our points: 0..31
  std::vector<double> rate_dps;  // of the turn, around each of our points

  /** Since the start of the block, s, by the manual. */
  double firingTime(size_t i) const
  {
    const sensors::VelodyneTiming t = sensors::timingOf(model);
    const auto in_block = static_cast<int>(record[i]);
    const int64_t ns = in_block / t.lasers * t.sequence_ns + t.firingNs(in_block % t.lasers);
    return 1e-9 * static_cast<double>(ns);
  }

  /** The time of a record within its block as the package has it. */
  double theirFiringTime(size_t i) const
  {
    const auto y = static_cast<double>(record[i]);
    switch (model)
    {
      case sensors::VelodyneModel::vlp16:
        return 1e-6 * (55.296 * y / 16 + 2.304 * static_cast<double>(record[i] % 16));
      case sensors::VelodyneModel::vlp32c:
        return 1e-6 * 2.304 * y / 2;
      case sensors::VelodyneModel::hdl32e:
        return 1e-6 * 1.152 * y / 2;
    }
    return 0;
  }
};

inline void findRecordsOfBlock(const sensors::VelodyneData& data, int block, BothClouds& both)
{
  const double rate = data.azimuthStep(block) / 100.0 /
                      (1e-9 * static_cast<double>(sensors::timingOf(both.model).blockNs()));
  for (int record = 0; record < sensors::kVelodyneRecords; ++record)
  {
    if (data.record(block, record).distance != 0)
    {
      both.record.push_back(static_cast<size_t>(record));
      both.rate_dps.push_back(rate);
    }
  }
}

/** Walks over the raw records as both decoders do. */
inline void findRecords(const Capture& capture, BothClouds& both)
{
  for (const auto& packet : capture.packets)
  {
    const auto data = sensors::VelodyneData::check(packet);
    ASSERT_TRUE(data);
    for (int block = 0; block < sensors::kVelodyneBlocks; ++block)
    {
      findRecordsOfBlock(*data, block, both);
    }
  }
}

inline BothClouds decodeBoth(const VelodyneCloudCase& c, const Capture& capture)
{
  BothClouds both{c.model, {}, recordedCloud(c.recorded), {}, {}};
  points::VelodyneInput input;
  const auto views = capture.views();
  input.packets = views;
  both.ours = points::decodeVelodyne(input);
  findRecords(capture, both);
  return both;
}

inline void expectSameTotals(const BothClouds& both)
{
  const auto& factory = sensors::factoryCalibration(both.model);
  const std::vector<uint16_t> ring = sensors::ringsOf(factory, both.model);
  std::vector<RecordedCloud::Laser> sums(ring.size());
  const points::ScanBuffer& scan = both.ours.scan;
  for (size_t i = 0; i < scan.size(); ++i)
  {
    RecordedCloud::Laser& sum = sums[scan.ring[i]];
    ++sum.count;
    sum.distance_m += std::hypot(scan.x[i], scan.y[i], scan.z[i]);
    sum.z_m += scan.z[i];
    sum.intensity += std::round(scan.intensity[i] * 255);
  }
  for (const RecordedCloud::Laser& theirs : both.theirs.lasers)
  {
    const RecordedCloud::Laser& sum = sums[ring.at(theirs.laser)];
    EXPECT_EQ(sum.count, theirs.count) << "laser " << theirs.laser;
    EXPECT_EQ(sum.intensity, theirs.intensity) << "laser " << theirs.laser;
    // Float coordinates (2e-6 m at 30 m) and sums rounded to 1 mm: 1e-5 m per point is ample.
    const double tolerance_m = 1e-3 + 1e-5 * static_cast<double>(sum.count);
    EXPECT_NEAR(sum.distance_m, theirs.distance_m, tolerance_m) << "laser " << theirs.laser;
    EXPECT_NEAR(sum.z_m, theirs.z_m, tolerance_m) << "laser " << theirs.laser;
  }
}

inline void expectSamePoint(const BothClouds& both, const RecordedCloud::Point& theirs)
{
  const points::ScanBuffer& scan = both.ours.scan;
  const size_t i = theirs.index;
  const std::vector<uint16_t> ring =
      sensors::ringsOf(sensors::factoryCalibration(both.model), both.model);
  EXPECT_EQ(scan.ring[i], ring[theirs.laser]);
  EXPECT_NEAR(scan.intensity[i] * 255, theirs.intensity, 1e-3);
  // They write 0.1 mm; floats of up to 131 m add 4e-6 m.
  EXPECT_NEAR(scan.z[i], theirs.z_m, 1e-4);
  const double turned_rad =
      both.rate_dps[i] * both.firingTime(i) * std::numbers::pi / 180;  // clockwise, since the block
  const double x = theirs.x_m * std::cos(turned_rad) + theirs.y_m * std::sin(turned_rad);
  const double y = theirs.y_m * std::cos(turned_rad) - theirs.x_m * std::sin(turned_rad);
  // Their 0.1 mm, and our azimuth's grid of 6.8e-7 rad.
  const double tolerance_m = 1.5e-4 + 1.4e-6 * std::hypot(x, y);
  EXPECT_NEAR(scan.x[i], x, tolerance_m);
  EXPECT_NEAR(scan.y[i], y, tolerance_m);
  // Times are floats of up to 0.5 s (3e-8 s) here, whole nanoseconds there.
  const double their_time_s = theirs.time_ns * 1e-9 - both.theirFiringTime(i) + both.firingTime(i);
  EXPECT_NEAR(scan.time_s[i], their_time_s, 5e-8);
}

/** Every recorded point, and the totals of each laser. */
inline void expectAgreement(const VelodyneCloudCase& c)
{
  const bool is_rawlog = c.packets.extension() == ".rawlog";
  const Capture capture = is_rawlog ? captureInRawlog(c.packets) : captureInPcap(c.packets);
  const BothClouds both = decodeBoth(c, capture);
  ASSERT_EQ(both.ours.scan.size(), capture.rawReturns());
  ASSERT_EQ(both.ours.scan.size(), both.theirs.count());
  ASSERT_EQ(both.record.size(), both.ours.scan.size());
  expectSameTotals(both);
  ASSERT_GT(both.theirs.points.size(), 50U);
  for (const RecordedCloud::Point& theirs : both.theirs.points)
  {
    ASSERT_LT(theirs.index, both.ours.scan.size());
    ASSERT_NO_FATAL_FAILURE(expectSamePoint(both, theirs));
    ASSERT_FALSE(::testing::Test::HasFailure()) << "first difference at point " << theirs.index;
  }
}
}  // namespace traverse::testing
