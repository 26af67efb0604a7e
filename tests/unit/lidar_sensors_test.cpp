// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/multi_lidar_grid/sensors.h>

#include <gtest/gtest.h>

namespace
{
using namespace traverse;
using namespace traverse::multi_lidar_grid;
using poses::TimeNs;

constexpr TimeNs kSecond = 1'000'000'000;
constexpr TimeNs kSweep = kSecond / 10;

points::ScanBuffer onePoint(float x)
{
  points::ScanBuffer scan;
  scan.x = {x};
  scan.y = {0};
  scan.z = {0};
  return scan;
}

/** A sensor of which ten clouds came, the last one at 1 s. */
class LidarSensors : public ::testing::Test
{
 protected:
  void SetUp() override
  {
    for (int i = 1; i <= 10; ++i)
    {
      EXPECT_EQ(arriveAt(i * kSweep, static_cast<float>(i)), Refusal::none);
    }
  }

  Refusal arriveAt(TimeNs stamp, float what, double place_m = 0)
  {
    return arrive(sensor_, onePoint(what).view(), stamp, {place_m, 0, 0}, params_);
  }

  Health healthAfter(double seconds) const
  {
    return healthOf(sensor_, kSecond + static_cast<TimeNs>(seconds * 1e9), params_);
  }

  Params params_;
  Sensor sensor_{"roof", 10};
};
}  // namespace

TEST_F(LidarSensors, FallSilentByAndBy)
{
  EXPECT_NEAR(sensor_.period_s, 0.1, 1e-9);
  EXPECT_EQ(healthAfter(0.15), Health::ok);
  EXPECT_EQ(healthAfter(0.25), Health::late);
  EXPECT_EQ(healthAfter(0.55), Health::stale);
  EXPECT_EQ(healthAfter(5.1), Health::dead);
  params_.sensor_labels = "left roof";
  params_.sensor_timeouts_s = {0.3, 2};
  EXPECT_EQ(healthAfter(0.55), Health::late);
}

TEST_F(LidarSensors, TakeWhatComesOutOfOrderWithinTheWindow)
{
  EXPECT_EQ(arriveAt(kSecond - kSweep / 2, 20), Refusal::none);
  EXPECT_EQ(sensor_.newest, kSecond);
  EXPECT_EQ(arriveAt(-kSweep, 21), Refusal::too_late);
  EXPECT_EQ(sensor_.refused, 1U);
  EXPECT_EQ(sensor_.clouds, 11U);
}

TEST_F(LidarSensors, AreStuckWhenTheSameCloudComesAgainAndAgain)
{
  for (int i = 1; i <= 3; ++i)
  {
    EXPECT_EQ(healthOf(sensor_, sensor_.newest, params_), Health::ok);
    EXPECT_EQ(arriveAt(kSecond + i * kSweep, 10), Refusal::none) << "the vehicle may stand";
  }
  EXPECT_EQ(healthOf(sensor_, sensor_.newest, params_), Health::stuck);
  EXPECT_EQ(arriveAt(kSecond + 4 * kSweep, 10, 1.0), Refusal::stuck) << "it does not";
  EXPECT_EQ(arriveAt(kSecond + 5 * kSweep, 11, 1.5), Refusal::none);
  EXPECT_EQ(healthOf(sensor_, sensor_.newest, params_), Health::ok);
}

TEST(LidarSensorList, HasABitForEachAndOneForAllBeyond)
{
  Sensors sensors;
  for (int i = 0; i < 40; ++i)
  {
    Sensor& sensor = sensors.obtain("lidar" + std::to_string(i), 4);
    EXPECT_EQ(sensors.bitOf(sensor), 1U << std::min(i, 31));
  }
  EXPECT_EQ(sensors.all().size(), Sensors::kMost);
  EXPECT_EQ(&sensors.obtain("lidar3", 4), &sensors.all()[3]);
}
