// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "convert.h"

#include <traverse/formats/bytes.h>

#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <numbers>

namespace traverse::ros_bags
{
namespace
{
using mrpt::obs::CObservation2DRangeScan;

struct Beam
{
  float range_m = 0;
  bool valid = false;
};

/** REP-117: +Inf is no return, -Inf too near, NaN an error. What is invalid keeps its reason in its
 * range (points/range_row.h): the longest (or 0) is no return, any other an error. */
Beam beamOf(float range_m, const LaserScan& scan, float max_m)
{
  constexpr float kError_m = 0.001F;
  if (std::isnan(range_m) || range_m < 0)
  {
    return {kError_m, false};
  }
  if (range_m > max_m)
  {
    return {max_m, false};
  }
  return {range_m, range_m > 0 && range_m >= scan.range_min_m};
}

void checkAngles(const LaserScan& scan)
{
  constexpr double kTurn = 2 * std::numbers::pi;
  const double aperture =
      std::abs(static_cast<double>(scan.step_rad)) * static_cast<double>(scan.ranges_m.size() - 1);
  const bool good = scan.ranges_m.size() > 1 && scan.step_rad != 0 && aperture <= kTurn * 1.01 &&
                    std::abs(scan.angle_min_rad) <= kTurn;
  if (!good)
  {
    throw formats::FormatError("LaserScan: angles or number of rays that are none");
  }
}

void setIntensities(CObservation2DRangeScan& to, const LaserScan& scan)
{
  if (scan.intensities.size() != scan.ranges_m.size())
  {
    return;
  }
  to.setScanHasIntensity(true);
  constexpr float kMost = 1e9F;
  for (size_t i = 0; i < scan.intensities.size(); ++i)
  {
    const float v = scan.intensities[i];
    const float clamped = std::isfinite(v) ? std::clamp(v, -kMost, kMost) : 0.0F;
    to.setScanIntensity(i, static_cast<int>(std::lround(clamped)));
  }
}
}  // namespace

importing::Entry fromLaser(const LaserScan& scan, const Origin& origin, Surroundings& around)
{
  checkAngles(scan);
  constexpr float kNoLimit_m = 1000;
  const bool limited = scan.range_max_m > 0 && scan.range_max_m <= kNoLimit_m;
  auto to = CObservation2DRangeScan::Create();
  const double turn =
      static_cast<double>(scan.step_rad) * static_cast<double>(scan.ranges_m.size() - 1);
  to->rightToLeft = scan.step_rad > 0;
  to->aperture = static_cast<float>(std::abs(turn));
  to->maxRange = limited ? scan.range_max_m : kNoLimit_m;
  to->resizeScan(scan.ranges_m.size());
  for (size_t i = 0; i < scan.ranges_m.size(); ++i)
  {
    const Beam beam = beamOf(scan.ranges_m[i], scan, to->maxRange);
    to->setScanRange(i, beam.range_m);
    to->setScanRangeValidity(i, beam.valid);
  }
  setIntensities(*to, scan);
  // MRPT's rays lie evenly about the sensor's x axis.
  const double middle = scan.angle_min_rad + turn / 2;
  to->sensorPose = around.sensorPose(scan.header.frame, origin.stamp_ns) +
                   mrpt::poses::CPose3D(0, 0, 0, middle, 0, 0);
  if (scan.beam_time_s > 0)
  {
    around.notes().warn(fmt::format(
        "{}: its rays are {} s apart, for which CObservation2DRangeScan has no place", origin.topic,
        scan.beam_time_s));
  }
  return {to, {}};
}

importing::Entry fromVelodyne(
    const VelodynePackets& packets, const Origin& origin, Surroundings& around)
{
  using mrpt::obs::CObservationVelodyneScan;
  static_assert(sizeof(CObservationVelodyneScan::TVelodyneRawPacket) == VelodynePackets::kBytes);
  if (packets.packets.empty())
  {
    throw formats::FormatError("VelodyneScan: has no packets");
  }
  auto to = CObservationVelodyneScan::Create();
  to->scan_packets.resize(packets.packets.size());
  for (size_t i = 0; i < packets.packets.size(); ++i)
  {
    const std::string_view bytes = packets.packets[i].second;
    std::memcpy(static_cast<void*>(&to->scan_packets[i]), bytes.data(), bytes.size());
  }
  constexpr uint8_t kVlp16 = 0x22;
  constexpr uint8_t kHdl32 = 0x21;
  const uint8_t model = to->scan_packets.front().velodyne_model_ID;
  if (model == kVlp16 || model == kHdl32)
  {
    to->calibration =
        mrpt::obs::VelodyneCalibration::LoadDefaultCalibration(model == kVlp16 ? "VLP16" : "HDL32");
  }
  to->sensorPose = around.sensorPose(packets.header.frame, origin.stamp_ns);
  return {to, {}};
}
}  // namespace traverse::ros_bags
