// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulated packets beside those of real sensors: periods, azimuth steps, packets of a turn, and
// how noisy ranges are.
#include "support/data.h"
#include "support/simulated_turns.h"
#include "support/velodyne_capture.h"

#include <traverse/sensors/velodyne_packet.h>
#include <traverse/sensors/velodyne_timing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace traverse::testing
{
namespace
{
using sensors::VelodyneData;
using sensors::VelodyneModel;

template <class T>
T medianOf(std::vector<T> values)
{
  EXPECT_FALSE(values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** What can be counted in packets. */
struct Figures
{
  double packet_us = 0;  //!< median, by the packets' clock
  double step_deg = 0;   //!< mean, from one block to the next
  double packets_a_turn = 0;
  double noise_m = 0;  //!< from one firing of a laser to its next, on what is smooth
};

/** Second differences of neighbours are 0 where a surface is smooth, but for noise, of which they
 * have six times the variance; the median lets edges and leaves alone. */
double noiseOf(const std::vector<VelodyneData>& packets)
{
  const auto lasers = static_cast<size_t>(sensors::timingOf(packets.front().model()).lasers);
  const double unit_m = sensors::factoryCalibration(packets.front().model()).distance_unit_m;
  std::vector<std::vector<double>> ranges(lasers);
  for (const VelodyneData& packet : packets)
  {
    for (int record = 0; record < sensors::kVelodyneBlocks * sensors::kVelodyneRecords; ++record)
    {
      const auto value =
          packet.record(record / sensors::kVelodyneRecords, record % sensors::kVelodyneRecords);
      ranges[static_cast<size_t>(record) % lasers].push_back(value.distance * unit_m);
    }
  }
  std::vector<double> differences;
  for (const std::vector<double>& r : ranges)
  {
    for (size_t i = 2; i < r.size(); ++i)
    {
      const double difference = r[i] - 2 * r[i - 1] + r[i - 2];
      const bool near = std::min({r[i], r[i - 1], r[i - 2]}) > 1 && r[i] < 25;
      if (near && std::abs(difference) < 0.15)
      {
        differences.push_back(std::abs(difference));
      }
    }
  }
  return 1.4826 * medianOf(differences) / std::sqrt(6.0);
}

Figures figuresOf(const std::vector<sensors::VelodynePacket>& views)
{
  std::vector<VelodyneData> packets;
  for (const sensors::VelodynePacket& view : views)
  {
    if (const auto packet = VelodyneData::check(view))
    {
      packets.push_back(*packet);
    }
  }
  std::vector<double> periods;
  double turned_deg = 0;
  for (size_t i = 1; i < packets.size(); ++i)
  {
    periods.push_back(
        static_cast<double>(packets[i].timeUs()) - static_cast<double>(packets[i - 1].timeUs()));
    turned_deg += (packets[i].azimuth(0) - packets[i - 1].azimuth(0) + 36000) % 36000 / 100.0;
  }
  Figures figures;
  figures.packet_us = medianOf(periods);
  const double packet_deg = turned_deg / static_cast<double>(periods.size());
  figures.step_deg = packet_deg / packets.front().groups();
  figures.packets_a_turn = 360 / packet_deg;
  figures.noise_m = noiseOf(packets);
  return figures;
}

/** Between two walls, as the defaults have it, at the real sensor's rate. */
Figures simulatedFigures(VelodyneModel model, double rate_hz)
{
  simulation::Scene scene = planeScene();
  scene.area = {-50, -50, 50, 50};
  scene.objects.push_back(boxObject({-50, 8, -1}, {50, 9, 10}));
  scene.objects.push_back(boxObject({-50, -9, -1}, {50, -8, 10}));
  simulation::LidarParams params;
  params.model = model;
  params.rate_hz = rate_hz;
  const simulation::Lidar lidar(params, 1);
  const simulation::RayCaster caster(scene);
  std::vector<simulation::LidarTurn> turns;
  std::vector<sensors::VelodynePacket> views;
  for (uint64_t k = 0; k < 3; ++k)
  {
    turns.push_back(lidar.turn(k, caster, standingStill()));
  }
  for (const simulation::LidarTurn& turn : turns)
  {
    views.insert(views.end(), turn.packets.begin(), turn.packets.end());
  }
  return figuresOf(views);
}

void expectAlike(const std::string& name, VelodyneModel model)
{
  const auto file = sharedData("velodyne-pcap/" + name);
  TRAVERSE_NEEDS(file);
  const Capture capture = captureInPcap(file);
  const Figures real = figuresOf(capture.views());
  const double block_s = 1e-9 * static_cast<double>(sensors::timingOf(model).blockNs());
  const Figures simulated = simulatedFigures(model, real.step_deg / 360 / block_s);
  ::testing::Test::RecordProperty("real_noise_mm", std::to_string(1000 * real.noise_m));
  ::testing::Test::RecordProperty("simulated_noise_mm", std::to_string(1000 * simulated.noise_m));
  EXPECT_NEAR(simulated.packet_us, real.packet_us, 1);  // the clock's grain
  EXPECT_NEAR(simulated.step_deg, real.step_deg, 0.001 * real.step_deg);
  EXPECT_NEAR(simulated.packets_a_turn, real.packets_a_turn, 0.001 * real.packets_a_turn);
  // Not less noisy than the real ones, and not twice as noisy.
  EXPECT_GT(simulated.noise_m, 0.9 * real.noise_m);
  EXPECT_LT(simulated.noise_m, 2 * real.noise_m);
}

TEST(SimulatedLidarFigures, AreThoseOfARealHdl32e)
{
  expectAlike("sample_velodyne_hdl32.pcap", VelodyneModel::hdl32e);
}

TEST(SimulatedLidarFigures, AreThoseOfARealVlp16)
{
  expectAlike("sample_velodyne_vlp16_gps.pcap", VelodyneModel::vlp16);
}

TEST(SimulatedLidarFigures, AreThoseOfARealVlp32c)
{
  expectAlike("nebula_vlp32c_front.pcap.gz", VelodyneModel::vlp32c);
}
}  // namespace
}  // namespace traverse::testing
