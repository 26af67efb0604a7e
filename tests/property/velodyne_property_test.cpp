// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simulated_velodyne.h"

#include <traverse/points/velodyne_scan.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace traverse::testing
{
namespace
{
using points::Decoded;
using points::Reject;
using sensors::ReturnMode;
using sensors::VelodyneModel;

using Pair = std::array<sensors::VelodyneReturn, 2>;

/** Random returns by laser and time: some none, some near, some as far as can be told. */
SimulatedVelodyne::World randomWorld(uint32_t seed)
{
  return [seed](int laser, double t_s)
  {
    // Both blocks of a pair ask for the same firing and must hear the same.
    std::mt19937 random(
        seed + 977U * static_cast<uint32_t>(laser) +
        static_cast<uint32_t>(std::llround(t_s * 1e9)));
    const auto one = [&]
    {
      return sensors::VelodyneReturn{
          random() % 4 == 0 ? uint16_t{0} : static_cast<uint16_t>(random() % 65536),
          static_cast<uint8_t>(random() % 256)};
    };
    const sensors::VelodyneReturn last = one();
    return Pair{last, random() % 4 == 0 ? last : one()};
  };
}

/** Walks over the firings of a simulated sensor in the packets' order and compares each return. */
class Identity
{
 public:
  Identity(const SimulatedVelodyne& sensor, const SimulatedVelodyne::World& world, int packets) :
      sensor_(sensor),
      world_(world),
      timing_(sensors::timingOf(sensor.model)),
      factory_(sensors::factoryCalibration(sensor.model)),
      ring_(sensors::ringsOf(factory_, sensor.model)),
      scan_(decode(sensor.run(packets, world)).scan),
      sequences_(
          packets * sensors::kVelodyneBlocks / (isDual() ? 2 : 1) * timing_.sequences_per_block)
  {
  }

  void check()
  {
    for (int k = 0; k < sequences_ * timing_.lasers; ++k)
    {
      const int laser = k % timing_.lasers;
      const int64_t t_ns = k / timing_.lasers * timing_.sequence_ns + timing_.firingNs(laser);
      ASSERT_NO_FATAL_FAILURE(checkFiring(laser, 1e-9 * static_cast<double>(t_ns)));
    }
    ASSERT_EQ(i_, scan_.size());
  }

 private:
  bool isDual() const { return sensor_.mode == ReturnMode::dual; }

  void checkFiring(int laser, double t_s)
  {
    const Pair returns = world_(laser, t_s);
    ASSERT_NO_FATAL_FAILURE(checkReturn(returns[0], laser, t_s));
    if (isDual() && returns[1].distance != returns[0].distance)
    {
      ASSERT_NO_FATAL_FAILURE(checkReturn(returns[1], laser, t_s));
    }
  }

  void checkReturn(const sensors::VelodyneReturn& r, int laser, double t_s)
  {
    if (r.distance == 0)
    {
      return;
    }
    ASSERT_LT(i_, scan_.size());
    const double range_m = r.distance * factory_.distance_unit_m;
    const Eigen::Vector3d p = range_m * sensor_.direction(laser, t_s);
    // Azimuths are stored to 0.01 degrees (1.75e-4 rad): half of it at the block, and in a packet's
    // last block, whose step is that of the one before, up to 0.81 of two such halves more.
    const double tolerance_m = 2.3e-4 * range_m + 1e-5;
    ASSERT_NEAR(scan_.x[i_], p.x(), tolerance_m) << "point " << i_;
    ASSERT_NEAR(scan_.y[i_], p.y(), tolerance_m) << "point " << i_;
    ASSERT_NEAR(scan_.z[i_], p.z(), 1e-5 + 1e-7 * range_m);
    ASSERT_EQ(scan_.ring[i_], ring_[static_cast<size_t>(laser)]);
    ASSERT_FLOAT_EQ(scan_.intensity[i_] * 255, r.intensity);
    // The packets' clock counts microseconds: half at the first packet, half at this one.
    ASSERT_NEAR(scan_.time_s[i_], t_s, 1.1e-6);
    ++i_;
  }

  const SimulatedVelodyne& sensor_;
  const SimulatedVelodyne::World& world_;
  sensors::VelodyneTiming timing_;
  const sensors::VelodyneCalibration& factory_;
  std::vector<uint16_t> ring_;
  points::ScanBuffer scan_;
  int sequences_;
  size_t i_ = 0;
};

TEST(VelodyneRoundTrip, IsTheIdentityUpToTheSensorsGrid)
{
  uint32_t seed = 1;
  for (const VelodyneModel model :
       {VelodyneModel::vlp16, VelodyneModel::hdl32e, VelodyneModel::vlp32c})
  {
    for (const ReturnMode mode : {ReturnMode::strongest, ReturnMode::last, ReturnMode::dual})
    {
      for (const double rate_dps : {1800.0, 3600.0, 7200.0})
      {
        const SimulatedVelodyne sensor{model, mode, rate_dps, 355, 3'599'990'000};
        const SimulatedVelodyne::World world = randomWorld(seed++);
        ASSERT_NO_FATAL_FAILURE(Identity(sensor, world, 4).check())
            << sensors::nameOf(model) << ", mode " << static_cast<int>(mode) << ", " << rate_dps;
      }
    }
  }
}

/** What must hold of any decoding. */
void expectSound(const Decoded& out, const Capture& capture)
{
  const size_t n = out.scan.size();
  ASSERT_EQ(out.scan.y.size(), n);
  ASSERT_EQ(out.scan.z.size(), n);
  ASSERT_EQ(out.scan.time_s.size(), n);
  ASSERT_EQ(out.scan.ring.size(), n);
  ASSERT_EQ(out.scan.intensity.size(), n);
  for (size_t i = 0; i < n; ++i)
  {
    ASSERT_TRUE(std::isfinite(out.scan.x[i] + out.scan.y[i] + out.scan.z[i] + out.scan.time_s[i]));
    ASSERT_LT(out.scan.ring[i], 32);
  }
  const uint64_t bad = out.rejects.of(Reject::bad_packet);
  ASSERT_LE(bad, capture.packets.size());
  ASSERT_LE(n + out.rejects.of(Reject::no_return), (capture.packets.size() - bad) * 384);
  ASSERT_EQ(
      out.image.size(),
      static_cast<size_t>(out.image.rows) * static_cast<size_t>(out.image.columns));
  ASSERT_LE(out.image.size(), 3 * (capture.packets.size() - bad) * 384);
}

std::vector<uint8_t> randomBytes(std::mt19937& random, size_t size)
{
  std::vector<uint8_t> bytes(size);
  std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<uint8_t>(random()); });
  return bytes;
}

TEST(VelodyneHostile, RandomBytesAreCounted)
{
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round)
  {
    Capture capture;
    for (int p = 0; p < 4; ++p)
    {
      capture.packets.push_back(
          randomBytes(random, random() % 8 == 0 ? random() % 1500 : sensors::kVelodynePacketBytes));
    }
    const Decoded out = decode(capture);
    ASSERT_NO_FATAL_FAILURE(expectSound(out, capture));
    ASSERT_EQ(out.rejects.of(Reject::bad_packet), 4U);
  }
}

/** Random bytes that pass for a packet. */
std::vector<uint8_t> randomPacket(std::mt19937& random, uint8_t model, uint8_t mode)
{
  std::vector<uint8_t> bytes = randomBytes(random, sensors::kVelodynePacketBytes);
  for (size_t block = 0; block < sensors::kVelodyneBlocks; ++block)
  {
    uint8_t* const at = &bytes[100 * block];
    at[0] = 0xFF;
    at[1] = 0xEE;
    at[3] = static_cast<uint8_t>(random() % 0x8C);  // below 36000
    if (mode == 0x39 && block % 2 == 1)
    {
      std::copy_n(at - 98, 2, at + 2);
    }
  }
  bytes[1204] = mode;
  bytes[1205] = model;
  return bytes;
}

TEST(VelodyneHostile, RandomContentInAValidFrameIsDecodedSoundly)
{
  std::mt19937 random(8);
  for (int round = 0; round < 300; ++round)
  {
    Capture capture;
    constexpr std::array<uint8_t, 3> kModels = {0x21, 0x22, 0x28};
    const uint8_t model = kModels[random() % 3];
    const auto mode = static_cast<uint8_t>(0x37 + random() % 3);
    for (int p = 0; p < 6; ++p)
    {
      capture.packets.push_back(randomPacket(random, model, mode));
    }
    const Decoded out = decode(capture);
    ASSERT_NO_FATAL_FAILURE(expectSound(out, capture));
    ASSERT_EQ(out.rejects.of(Reject::bad_packet), 0U);
  }
}

void damage(std::mt19937& random, std::vector<uint8_t>& packet)
{
  if (random() % 16 == 0)
  {
    packet.resize(random() % packet.size());
    return;
  }
  for (int flip = 0; flip < 8; ++flip)
  {
    packet[random() % packet.size()] ^= static_cast<uint8_t>(1U << random() % 8);
  }
}

TEST(VelodyneHostile, BitFlipsAndTruncationsOfGoodPacketsAreSurvived)
{
  const auto world = [](int, double) { return Pair{{{4000, 9}, {4100, 8}}}; };
  std::mt19937 random(9);
  uint64_t bad = 0;
  uint64_t good = 0;
  for (int round = 0; round < 1000; ++round)
  {
    SimulatedVelodyne sensor;
    sensor.model = static_cast<VelodyneModel>(random() % 3);
    sensor.mode = static_cast<ReturnMode>(0x37 + random() % 3);
    Capture capture = sensor.run(2, world);
    for (auto& packet : capture.packets)
    {
      damage(random, packet);
    }
    const Decoded out = decode(capture);
    ASSERT_NO_FATAL_FAILURE(expectSound(out, capture));
    bad += out.rejects.of(Reject::bad_packet);
    good += out.scan.size();
  }
  EXPECT_GT(bad, 100U);
  EXPECT_GT(good, 100'000U);
}

TEST(VelodyneHostile, AbsurdCalibrationsMakeNoAbsurdImage)
{
  std::mt19937 random(10);
  std::uniform_real_distribution<double> wide(-12, 12);
  const Capture capture = SimulatedVelodyne{}.run(
      6,
      [](int, double) {
        return Pair{{{4000, 9}, {}}};
      });
  for (int round = 0; round < 300; ++round)
  {
    sensors::VelodyneCalibration calibration;
    for (int i = 0; i < 16; ++i)
    {
      calibration.lasers.push_back(
          {wide(random) / 2, wide(random) / 8, wide(random) / 1.1, wide(random) / 1.2, 0});
    }
    points::VelodyneInput input;
    input.calibration = &calibration;
    ASSERT_NO_FATAL_FAILURE(expectSound(decode(capture, input), capture));
  }
}
}  // namespace
}  // namespace traverse::testing
