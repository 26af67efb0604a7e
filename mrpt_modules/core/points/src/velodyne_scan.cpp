// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "velodyne_beams.h"
#include "velodyne_image.h"
#include "velodyne_turn.h"

#include <traverse/points/velodyne_scan.h>
#include <traverse/sensors/velodyne_timing.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace traverse::points
{
namespace
{
using sensors::VelodyneReturn;

class TurnDecoder
{
 public:
  TurnDecoder(
      const VelodyneInput& input,
      const VelodyneTurn& turn,
      const sensors::VelodyneCalibration& calibration,
      Decoded& out) :
      turn_(turn),
      timing_(sensors::timingOf(turn.packets.front().data.model())),
      beams_(beamsOf(calibration, turn.packets.front().data.model())),
      unit_m_(calibration.distance_unit_m),
      limits_(input.limits),
      placement_(input.T_base_sensor),
      image_(beams_, planColumns(turn), timing_.lasers, out.image),
      out_(out)
  {
    out_.image.max_range_m = std::min(limits_.max_m, timing_.max_range_m);
  }

  void run()
  {
    resizePoints(turn_.packets.size() * sensors::kVelodyneBlocks * sensors::kVelodyneRecords);
    int sequence = 0;
    for (const TimedPacket& packet : turn_.packets)
    {
      for (int group = 0; group < packet.data.groups(); ++group)
      {
        decodeGroup(packet, group, sequence);
        sequence += timing_.sequences_per_block;
      }
    }
    resizePoints(points_);
  }

 private:
  void decodeGroup(const TimedPacket& packet, int group, int sequence)
  {
    const int64_t start_ns = packet.time_ns + group * timing_.blockNs();
    const sensors::AzimuthUnits start = packet.data.azimuth(group) * sensors::kUnitsPerHundredth;
    const int64_t step = int64_t{packet.data.azimuthStep(group)} * sensors::kUnitsPerHundredth;
    for (size_t record = 0; record < beams_.size(); ++record)
    {
      const VelodyneBeam& beam = beams_[record];
      const auto moved =
          static_cast<sensors::AzimuthUnits>((step * beam.part_of_step) >> VelodyneBeam::kPartBits);
      const Firing firing{
          beam, sensors::wrapped(start + moved + beam.azimuth_offset),
          static_cast<float>(
              static_cast<double>(start_ns + beam.firing_ns) * poses::kSecondsPerNs)};
      decodeBeam(packet.data, group, record, firing, sequence + beam.sequence);
    }
  }

  void decodeBeam(
      const sensors::VelodyneData& data,
      int group,
      size_t record,
      const Firing& firing,
      int sequence)
  {
    const auto index = static_cast<int>(record);
    size_t cell = VelodyneImage::kNoCell;
    if (image_.has(sequence))
    {
      cell = image_.indexOf(firing.beam, record, sequence);
      image_.aim(cell, firing);
    }
    const VelodyneReturn first = data.record(group * data.blocksPerGroup(), index);
    VelodyneReturn second;
    if (data.mode() == sensors::ReturnMode::dual)
    {
      second = data.record(group * 2 + 1, index);
      second = second.distance == first.distance ? VelodyneReturn{} : second;
    }
    if (first.distance == 0 && second.distance == 0)
    {
      out_.rejects.add(Reject::no_return);
      image_.mark(cell, Beam::no_return);
      return;
    }
    addReturn(first, firing, cell);
    addReturn(second, firing, cell);
  }

  void addReturn(const VelodyneReturn& measured, const Firing& firing, size_t cell)
  {
    if (measured.distance == 0)
    {
      return;
    }
    const double distance_m = measured.distance * unit_m_ + firing.beam.distance_offset_m;
    if (!(distance_m > 0) || distance_m < static_cast<double>(limits_.min_m))
    {
      out_.rejects.add(Reject::below_range);
      return;
    }
    if (distance_m > static_cast<double>(limits_.max_m))
    {
      out_.rejects.add(Reject::beyond_range);
      image_.mark(cell, Beam::no_return);
      return;
    }
    const std::array<double, 3> p_sensor = inSensor(firing, distance_m);
    const std::array<float, 3> p = placement_.inBase(p_sensor);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      out_.rejects.add(Reject::nonfinite);
      return;
    }
    addPoint(p, measured, firing);
    image_.hit(cell, firing, distance_m, p_sensor);
  }

  void addPoint(const std::array<float, 3>& p, const VelodyneReturn& measured, const Firing& firing)
  {
    ScanBuffer& scan = out_.scan;
    scan.x[points_] = p[0];
    scan.y[points_] = p[1];
    scan.z[points_] = p[2];
    scan.time_s[points_] = firing.time_s;
    scan.ring[points_] = firing.beam.ring;
    scan.intensity[points_] = static_cast<float>(measured.intensity) / 255.0F;
    ++points_;
  }

  void resizePoints(size_t n)
  {
    ScanBuffer& scan = out_.scan;
    for (std::vector<float>* channel : {&scan.x, &scan.y, &scan.z, &scan.time_s, &scan.intensity})
    {
      channel->resize(n);
    }
    scan.ring.resize(n);
  }

  const VelodyneTurn& turn_;
  sensors::VelodyneTiming timing_;
  VelodyneBeams beams_;
  double unit_m_;
  RangeLimits limits_;
  Placement placement_;
  VelodyneImage image_;
  Decoded& out_;
  size_t points_ = 0;
};
}  // namespace

Decoded decodeVelodyne(const VelodyneInput& input)
{
  Decoded out;
  out.scan.stamp = out.image.stamp = input.stamp;
  out.scan.sensor_label = out.image.sensor_label = input.sensor_label;
  out.scan.T_base_sensor = out.image.T_base_sensor = input.T_base_sensor;
  const VelodyneTurn turn = checkPackets(input.packets);
  out.rejects.add(Reject::bad_packet, turn.bad_packets);
  if (turn.packets.empty())
  {
    return out;
  }
  const sensors::VelodyneModel model = turn.packets.front().data.model();
  const sensors::VelodyneCalibration& calibration =
      input.calibration != nullptr ? *input.calibration : sensors::factoryCalibration(model);
  if (!sensors::fits(calibration, model))
  {
    out.rejects.add(Reject::bad_packet, turn.packets.size());
    return out;
  }
  TurnDecoder(input, turn, calibration, out).run();
  return out;
}
}  // namespace traverse::points
