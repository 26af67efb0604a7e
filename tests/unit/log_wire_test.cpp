// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <wire.h>

namespace
{
using namespace traverse;
using namespace traverse::logs;

points::Decoded sample()
{
  points::Decoded d;
  d.scan.stamp = 42;
  d.scan.sensor_label = "top";
  d.scan.T_base_sensor.translation().x() = 1.5;
  d.scan.x = {1, 2};
  d.scan.y = {3, 4};
  d.scan.z = {5, 6};
  d.scan.ring = {0, 1};
  d.image.rows = 1;
  d.image.columns = 3;
  d.image.beam = {points::Beam::hit, points::Beam::no_return, points::Beam::rejected};
  d.image.range_m = {7, std::numeric_limits<float>::quiet_NaN(), 0};
  d.image.azimuth_rad = {0, 1, 2};
  d.image.elevation_rad = {0, 0, 0};
  d.rejects.add(points::Reject::flagged, 9);
  return d;
}

std::vector<uint8_t> payloadOf(const points::Decoded& d)
{
  FrameWriter writer;
  writer.add(d);
  return {writer.bytes().begin() + sizeof(FrameHeader), writer.bytes().end()};
}

TEST(Wire, ScansArriveAsTheyWere)
{
  const points::Decoded back = readScan(payloadOf(sample()));
  EXPECT_EQ(back.scan.stamp, 42);
  EXPECT_EQ(back.image.sensor_label, "top");
  EXPECT_EQ(back.scan.T_base_sensor.translation().x(), 1.5);
  EXPECT_EQ(back.scan.z, sample().scan.z);
  EXPECT_EQ(back.scan.ring, sample().scan.ring);
  EXPECT_TRUE(back.scan.rgb.empty());
  EXPECT_EQ(back.image.beam, sample().image.beam);
  EXPECT_EQ(back.rejects.of(points::Reject::flagged), 9U);
}

TEST(Wire, InconsistentScansAreRefused)
{
  points::Decoded d = sample();
  d.scan.y.pop_back();
  EXPECT_THROW(readScan(payloadOf(d)), WireError);
  d = sample();
  d.scan.ring.push_back(1);
  EXPECT_THROW(readScan(payloadOf(d)), WireError);
  d = sample();
  d.image.rows = 2;
  EXPECT_THROW(readScan(payloadOf(d)), WireError);
  d = sample();
  d.image.rows = d.image.columns = -1;
  EXPECT_THROW(readScan(payloadOf(d)), WireError);
  d = sample();
  d.image.beam[0] = static_cast<points::Beam>(77);
  EXPECT_THROW(readScan(payloadOf(d)), WireError);
  d = sample();
  d.scan.x[0] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(readScan(payloadOf(d)), WireError);
}

TEST(Wire, EveryTruncationIsRefused)
{
  const std::vector<uint8_t> whole = payloadOf(sample());
  for (size_t n = 0; n < whole.size(); ++n)
  {
    EXPECT_THROW(readScan(std::span(whole).first(n)), WireError) << n;
  }
  std::vector<uint8_t> longer = whole;
  longer.push_back(0);
  EXPECT_THROW(readScan(longer), WireError);
}

TEST(Wire, RandomDamageIsReadOrRefusedButNeverCrashes)
{
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i)
  {
    std::vector<uint8_t> bytes = payloadOf(sample());
    for (int flips = 0; flips < 3; ++flips)
    {
      bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
    }
    try
    {
      const points::Decoded d = readScan(bytes);
      EXPECT_EQ(d.scan.x.size(), d.scan.z.size());
    }
    catch (const WireError&)
    {
    }
  }
}

TEST(Wire, CountsPosesAndDamagesArrive)
{
  FrameWriter writer;
  writer.add(CountFrame{Counted::rejected, "CObservationX", "why"});
  const std::span<const uint8_t> count = std::span(writer.bytes()).subspan(sizeof(FrameHeader));
  EXPECT_EQ(readCount(count).reason, "why");
  EXPECT_THROW(readPose(count), WireError);
  FrameWriter damage;
  damage.add(DamageFrame{true, "cut"});
  const std::span<const uint8_t> bytes = std::span(damage.bytes()).subspan(sizeof(FrameHeader));
  EXPECT_TRUE(readDamage(bytes).not_a_log);
  EXPECT_EQ(readDamage(bytes).message, "cut");
}
}  // namespace
