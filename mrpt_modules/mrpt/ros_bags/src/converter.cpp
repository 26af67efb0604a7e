// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "converter.h"

#include <traverse/formats/bytes.h>
#include <traverse/observations/cause.h>
#include <traverse/observations/convert.h>

namespace traverse::ros_bags
{
namespace
{
constexpr int64_t kNsPerS = 1'000'000'000;

/** Simulators count from 0; readers of logs take only times from 1980 to 2100 for a clock's. */
int64_t clockTime(int64_t stamp_ns, Notes& notes)
{
  constexpr int64_t kSeconds1980 = 315'532'800;
  constexpr int64_t kSeconds2000 = 946'684'800;
  if (stamp_ns >= kSeconds1980 * kNsPerS)
  {
    return stamp_ns;
  }
  notes.warn("stamps before 1980 (a simulator's): they are counted from 2000-01-01");
  return stamp_ns + kSeconds2000 * kNsPerS;
}
}  // namespace

std::optional<Pending> Converter::convert(const BagMessage& message)
{
  const KnownType* known = knownType(message.type);
  if (known == nullptr)
  {
    return std::nullopt;
  }
  if (known->md5sum != message.md5sum)
  {
    around_.notes().skipped(
        message.topic + ": its " + message.type + " has another definition (md5sum " +
        message.md5sum + ")");
    return std::nullopt;
  }
  try
  {
    return convert(message, known->kind);
  }
  catch (const formats::FormatError& e)
  {
    around_.notes().skipped(message.topic + ": " + e.what());
  }
  catch (const std::exception& e)  // MRPT's own checks
  {
    around_.notes().skipped(message.topic + ": " + observations::causeOf(e));
  }
  return std::nullopt;
}

Origin Converter::originOf(const BagMessage& message, const Header& header)
{
  if (header.stamp_ns != 0)
  {
    return {message.topic, header.stamp_ns};
  }
  around_.notes().skipped(message.topic + ": stamps (0; the time of recording is taken)");
  return {message.topic, message.recorded_ns};
}

std::optional<Pending> Converter::finish(
    const BagMessage& message, const Header& header, importing::Entry entry)
{
  Pending pending;
  pending.stamp_ns = header.stamp_ns != 0 ? header.stamp_ns : message.recorded_ns;
  pending.recorded_ns = message.recorded_ns;
  pending.bytes = message.bytes.size();
  pending.topic = message.topic;
  pending.frame = header.frame;
  entry.observation->timestamp =
      observations::toTimePoint(clockTime(pending.stamp_ns, around_.notes()));
  entry.observation->sensorLabel = around_.label(message.topic);
  pending.entry = std::move(entry);
  return pending;
}

std::optional<Pending> Converter::convert(const BagMessage& message, MessageKind kind)
{
  const auto by = [&](const auto& parsed, const auto& from) {
    return finish(message, parsed.header, from(parsed, originOf(message, parsed.header), around_));
  };
  switch (kind)
  {
    case MessageKind::transforms:
      return std::nullopt;  // the first pass took them
    case MessageKind::camera_info:
      around_.setCamera(message.topic, parseCameraInfo(message.bytes));
      return std::nullopt;
    case MessageKind::point_cloud:
      return by(parsePointCloud(message.bytes), fromCloud);
    case MessageKind::laser_scan:
      return by(parseLaserScan(message.bytes), fromLaser);
    case MessageKind::image:
      return by(parseImage(message.bytes), fromImage);
    case MessageKind::odometry:
      return by(parseOdometry(message.bytes), fromOdometry);
    case MessageKind::imu:
      return by(parseImu(message.bytes), fromImu);
    case MessageKind::fix:
      return by(parseNavSatFix(message.bytes), fromFix);
    case MessageKind::velodyne:
    {
      VelodynePackets packets = parseVelodynePackets(message.bytes);
      if (!packets.packets.empty() && packets.packets.front().first != 0)
      {
        // The driver stamps the scan at its end; in a log it starts at its stamp.
        packets.header.stamp_ns = packets.packets.front().first;
      }
      return by(packets, fromVelodyne);
    }
  }
  return std::nullopt;
}
}  // namespace traverse::ros_bags
