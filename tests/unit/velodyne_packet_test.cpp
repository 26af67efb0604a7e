// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sensors/exact_angle.h>
#include <traverse/sensors/velodyne_encode.h>
#include <traverse/sensors/velodyne_packet.h>
#include <traverse/sensors/velodyne_timing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace traverse::sensors
{
namespace
{
/** A packet of a sensor that turns by so many hundredths of a degree per block. */
VelodynePacketContent turning(VelodyneModel model, int step_hundredths, int start = 100)
{
  VelodynePacketContent content;
  content.model = model;
  content.time_us = 3'599'999'000;
  for (int block = 0; block < kVelodyneBlocks; ++block)
  {
    VelodyneBlock& b = content.blocks[static_cast<size_t>(block)];
    b.azimuth = static_cast<uint16_t>((start + block * step_hundredths) % 36000);
    for (int i = 0; i < kVelodyneRecords; ++i)
    {
      b.records[static_cast<size_t>(i)] = {
          static_cast<uint16_t>(1000 * block + i), static_cast<uint8_t>(block + i)};
    }
  }
  return content;
}

TEST(ExactAngle, IsTheSineAndCosineEverywhere)
{
  for (AzimuthUnits units = 0; units < kUnitsPerTurn; units += 997)
  {
    const SinCos ours = sinCosOf(units);
    const double angle_rad = units * kRadPerUnit;
    // 2e-16 of our own, 1 ulp of libm, and the rounding of the angle itself (4e-16 at 2 pi).
    ASSERT_NEAR(ours.sin, std::sin(angle_rad), 1e-15) << units;
    ASSERT_NEAR(ours.cos, std::cos(angle_rad), 1e-15) << units;
  }
  for (int i = -700; i < 700; ++i)
  {
    const double angle_rad = i * 0.01;
    ASSERT_NEAR(sinCosOf(angle_rad).sin, std::sin(angle_rad), 2e-15) << angle_rad;
    ASSERT_NEAR(sinCosOf(angle_rad).cos, std::cos(angle_rad), 2e-15) << angle_rad;
  }
}

TEST(ExactAngle, HasTheSameBitsAtRunTimeAsInTheCompiler)
{
  // The compiler computes with exact rounding whatever processor it runs on.
  constexpr SinCos kAtCompileTime = sinCosOf(AzimuthUnits{1'234'567});
  volatile AzimuthUnits hidden = 1'234'567;
  const SinCos at_run_time = sinCosOf(AzimuthUnits{hidden});
  EXPECT_EQ(at_run_time.sin, kAtCompileTime.sin);
  EXPECT_EQ(at_run_time.cos, kAtCompileTime.cos);
  EXPECT_EQ(sinCosOf(AzimuthUnits{90 * kUnitsPerDegree}).cos, 0) << "quarters are exact";
}

TEST(ExactAngle, WrapsIntoOneTurn)
{
  EXPECT_EQ(wrapped(kUnitsPerTurn), 0);
  EXPECT_EQ(wrapped(-1), kUnitsPerTurn - 1);
  EXPECT_EQ(wrapped(2 * kUnitsPerTurn + 5), 5);
}

TEST(FactoryCalibration, HasTheRingsOfTheManuals)
{
  const auto vlp16 = ringsOf(factoryCalibration(VelodyneModel::vlp16), VelodyneModel::vlp16);
  EXPECT_EQ(vlp16, (std::vector<uint16_t>{0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15}));
  const auto hdl = ringsOf(factoryCalibration(VelodyneModel::hdl32e), VelodyneModel::hdl32e);
  EXPECT_EQ(hdl[0], 0);    // -30.67 degrees
  EXPECT_EQ(hdl[1], 16);   // -9.33
  EXPECT_EQ(hdl[31], 31);  // 10.67
  const auto vlp32c = ringsOf(factoryCalibration(VelodyneModel::vlp32c), VelodyneModel::vlp32c);
  EXPECT_EQ(vlp32c[0], 0);    // -25 degrees
  EXPECT_EQ(vlp32c[3], 1);    // -15.639
  EXPECT_EQ(vlp32c[29], 31);  // 15
}

TEST(FactoryCalibration, HasEvenlySpacedLasersWhereTheSensorHas)
{
  for (const VelodyneModel model : {VelodyneModel::vlp16, VelodyneModel::hdl32e})
  {
    std::vector<double> elevation_deg;
    for (const auto& laser : factoryCalibration(model).lasers)
    {
      elevation_deg.push_back(laser.elevation_rad / kRadPerDegree);
    }
    std::sort(elevation_deg.begin(), elevation_deg.end());
    const double spacing = model == VelodyneModel::vlp16 ? 2.0 : 4.0 / 3;
    for (size_t i = 1; i < elevation_deg.size(); ++i)
    {
      // The HDL-32E's table is rounded to 0.01 degrees.
      EXPECT_NEAR(elevation_deg[i] - elevation_deg[i - 1], spacing, 0.011);
    }
  }
}

TEST(Calibration, OfALogMustFitTheModel)
{
  const VelodyneCalibration good = factoryCalibration(VelodyneModel::vlp16);
  EXPECT_TRUE(fits(good, VelodyneModel::vlp16));
  EXPECT_FALSE(fits(good, VelodyneModel::hdl32e)) << "16 lasers of 32";
  EXPECT_TRUE(fits(factoryCalibration(VelodyneModel::hdl32e), VelodyneModel::vlp16));
  VelodyneCalibration bad = good;
  bad.lasers[15].elevation_rad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fits(bad, VelodyneModel::vlp16));
  bad = good;
  bad.lasers[3].horizontal_offset_m = 1e300;
  EXPECT_FALSE(fits(bad, VelodyneModel::vlp16));
  for (const double unit_m : {0.0, -0.002, 1.0, std::numeric_limits<double>::infinity()})
  {
    bad = good;
    bad.distance_unit_m = unit_m;
    EXPECT_FALSE(fits(bad, VelodyneModel::vlp16)) << unit_m;
  }
}

TEST(VelodyneTiming, FillsOneBlockAndLeavesTimeToRecharge)
{
  for (const VelodyneModel model :
       {VelodyneModel::vlp16, VelodyneModel::hdl32e, VelodyneModel::vlp32c})
  {
    const VelodyneTiming timing = timingOf(model);
    EXPECT_EQ(timing.lasers * timing.sequences_per_block, kVelodyneRecords);
    EXPECT_LT(timing.firingNs(timing.lasers - 1) + timing.slot_ns, timing.sequence_ns);
  }
  EXPECT_EQ(timingOf(VelodyneModel::vlp16).blockNs(), 110'592);
  EXPECT_EQ(timingOf(VelodyneModel::hdl32e).firingNs(31), 35'712);
  EXPECT_EQ(timingOf(VelodyneModel::vlp32c).firingNs(1), 0);
  EXPECT_EQ(timingOf(VelodyneModel::vlp32c).firingNs(31), 34'560);
}

TEST(VelodyneData, ReadsWhatWasEncoded)
{
  const VelodynePacketContent content = turning(VelodyneModel::vlp32c, 20);
  const auto bytes = encodeVelodyne(content);
  const auto data = VelodyneData::check(bytes);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->model(), VelodyneModel::vlp32c);
  EXPECT_EQ(data->mode(), ReturnMode::strongest);
  EXPECT_EQ(data->timeUs(), 3'599'999'000U);
  for (int block = 0; block < kVelodyneBlocks; ++block)
  {
    EXPECT_EQ(data->azimuth(block), content.blocks[static_cast<size_t>(block)].azimuth);
    for (int i = 0; i < kVelodyneRecords; ++i)
    {
      EXPECT_EQ(
          data->record(block, i),
          content.blocks[static_cast<size_t>(block)].records[static_cast<size_t>(i)]);
    }
  }
}

TEST(VelodyneData, PairsBlocksInDualMode)
{
  VelodynePacketContent content = turning(VelodyneModel::hdl32e, 15);
  content.mode = ReturnMode::dual;
  EXPECT_FALSE(VelodyneData::check(encodeVelodyne(content))) << "a pair with two azimuths";
  for (size_t block = 1; block < kVelodyneBlocks; block += 2)
  {
    content.blocks[block].azimuth = content.blocks[block - 1].azimuth;
  }
  const auto bytes = encodeVelodyne(content);
  const auto data = VelodyneData::check(bytes);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->groups(), 6);
  EXPECT_EQ(data->azimuth(5), content.blocks[10].azimuth);
  EXPECT_EQ(data->azimuthStep(2), 30);
}

TEST(VelodyneData, RefusesEveryBrokenField)
{
  const auto good = encodeVelodyne(turning(VelodyneModel::vlp16, 40));
  ASSERT_TRUE(VelodyneData::check(good));
  const auto broken = [&](size_t at, uint8_t value)
  {
    auto bytes = good;
    bytes[at] = value;
    return !VelodyneData::check(bytes);
  };
  EXPECT_TRUE(broken(0, 0xFE)) << "id of the first block";
  EXPECT_TRUE(broken(1101, 0xDD)) << "id of the last block: a lower bank, of an HDL-64E";
  EXPECT_TRUE(broken(703, 0x8D)) << "azimuth of 36096 or more";
  EXPECT_TRUE(broken(1204, 0x36)) << "return mode";
  EXPECT_TRUE(broken(1204, 0x3A)) << "return mode";
  EXPECT_TRUE(broken(1205, 0x24)) << "a model that is not known";
}

TEST(VelodyneData, RefusesEveryOtherLength)
{
  const auto good = encodeVelodyne(turning(VelodyneModel::vlp16, 40));
  std::vector<uint8_t> bytes(good.begin(), good.end());
  for (size_t length = 0; length < bytes.size(); ++length)
  {
    EXPECT_FALSE(VelodyneData::check(VelodynePacket(bytes).first(length))) << length;
  }
  bytes.push_back(0);
  EXPECT_FALSE(VelodyneData::check(bytes));
  EXPECT_FALSE(VelodyneData::check(std::vector<uint8_t>(kVelodynePositionBytes))) << "GPS";
}

TEST(VelodyneData, TakesTheStepOfTheNearestPlausibleBlock)
{
  VelodynePacketContent content = turning(VelodyneModel::vlp16, 40, 35'900);
  const auto step = [&](int group)
  {
    const auto bytes = encodeVelodyne(content);
    return VelodyneData::check(bytes)->azimuthStep(group);
  };
  EXPECT_EQ(step(2), 40) << "over the wrap: 35980 -> 20";
  EXPECT_EQ(step(11), 40) << "the last block has the step of the one before";
  content.blocks[5].azimuth = 18'000;  // a jump, there and back
  EXPECT_EQ(step(4), 40);
  EXPECT_EQ(step(5), 40);
  content = turning(VelodyneModel::vlp16, 0);
  EXPECT_EQ(step(3), 0) << "a sensor that stands";
  content = turning(VelodyneModel::vlp16, 3000);
  EXPECT_EQ(step(3), 0) << "no block has a step that a sensor can make";
}

TEST(VelodyneEncode, RoundsDistances)
{
  EXPECT_EQ(countOfDistance(10, 0.002), 5000);
  EXPECT_EQ(countOfDistance(0.0009, 0.002), 0);
  EXPECT_EQ(countOfDistance(131.07, 0.002), 65535);
  EXPECT_EQ(countOfDistance(131.072, 0.002), 0) << "out of what a packet can say";
  EXPECT_EQ(countOfDistance(std::numeric_limits<double>::quiet_NaN(), 0.002), 0);
  EXPECT_EQ(countOfDistance(-1, 0.002), 0);
}
}  // namespace
}  // namespace traverse::sensors
