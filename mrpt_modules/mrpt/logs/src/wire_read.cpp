// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "wire.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace traverse::logs
{
namespace
{
constexpr uint64_t kLongestText = 4096;
constexpr uint32_t kMostInputPoints = 1U << 28U;

/** Takes values off a payload; nothing is read or allocated beyond what is there. */
class Payload
{
 public:
  explicit Payload(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  template <class T>
  T take()
  {
    T value{};
    copy(&value, sizeof(T));
    return value;
  }

  template <class T>
  std::vector<T> takeVector()
  {
    const auto n = take<uint64_t>();
    if (n > bytes_.size() / sizeof(T))
    {
      throw WireError("an array is longer than its frame");
    }
    std::vector<T> values(n);
    copy(values.data(), n * sizeof(T));
    return values;
  }

  std::string takeText()
  {
    const auto n = take<uint64_t>();
    if (n > std::min<uint64_t>(kLongestText, bytes_.size()))
    {
      throw WireError("a text is longer than its frame");
    }
    std::string text(n, '\0');
    copy(text.data(), n);
    return text;
  }

  Eigen::Isometry3d takePose()
  {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        T.matrix()(row, column) = take<double>();
      }
    }
    return T;
  }

  void finish() const
  {
    if (!bytes_.empty())
    {
      throw WireError("a frame is longer than its content");
    }
  }

 private:
  void copy(void* to, size_t n)
  {
    if (n > bytes_.size())
    {
      throw WireError("a frame is shorter than its content");
    }
    if (n > 0)
    {
      std::memcpy(to, bytes_.data(), n);
    }
    bytes_ = bytes_.subspan(n);
  }

  std::span<const uint8_t> bytes_;
};

void checkLengths(
    size_t n, std::initializer_list<size_t> always, std::initializer_list<size_t> or_none)
{
  const bool ok =
      std::all_of(always.begin(), always.end(), [&](size_t v) { return v == n; }) &&
      std::all_of(or_none.begin(), or_none.end(), [&](size_t v) { return v == n || v == 0; });
  if (!ok)
  {
    throw WireError("the arrays of a scan differ in length");
  }
}

bool allFinite(const std::vector<float>& values)
{
  return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
}

void takeScan(Payload& payload, points::ScanBuffer& scan)
{
  scan.stamp = payload.take<poses::TimeNs>();
  scan.sensor_label = payload.takeText();
  scan.T_base_sensor = payload.takePose();
  for (auto* channel : {&scan.x, &scan.y, &scan.z, &scan.time_s, &scan.intensity})
  {
    *channel = payload.takeVector<float>();
  }
  scan.ring = payload.takeVector<uint16_t>();
  scan.rgb = payload.takeVector<uint32_t>();
  scan.input_index = payload.takeVector<uint32_t>();
  scan.input_points = payload.take<uint32_t>();
  checkLengths(
      scan.size(), {scan.y.size(), scan.z.size()},
      {scan.time_s.size(), scan.intensity.size(), scan.ring.size(), scan.rgb.size(),
       scan.input_index.size()});
  const bool indexed = std::all_of(
      scan.input_index.begin(), scan.input_index.end(),
      [&](uint32_t i) { return i < scan.input_points; });
  if (!indexed || scan.input_points > kMostInputPoints)
  {
    throw WireError("points of a scan come from nowhere");
  }
  if (!scan.T_base_sensor.matrix().allFinite() || !allFinite(scan.x) || !allFinite(scan.y) ||
      !allFinite(scan.z) || !allFinite(scan.time_s))
  {
    throw WireError("a scan has values that are no numbers");
  }
}

void takeImage(Payload& payload, points::RangeImage& image)
{
  image.T_base_sensor = payload.takePose();
  image.rows = payload.take<int>();
  image.columns = payload.take<int>();
  image.closes = payload.take<uint8_t>() != 0;
  image.max_range_m = payload.take<float>();
  image.beam = payload.takeVector<points::Beam>();
  for (auto* channel : {&image.range_m, &image.azimuth_rad, &image.elevation_rad, &image.time_s})
  {
    *channel = payload.takeVector<float>();
  }
  const bool sized = image.rows >= 0 && image.columns >= 0 &&
                     uint64_t(image.rows) * uint64_t(image.columns) == image.size();
  const bool known_beams = std::all_of(
      image.beam.begin(), image.beam.end(),
      [](points::Beam beam) { return static_cast<uint8_t>(beam) <= 2; });
  if (!sized || !known_beams)
  {
    throw WireError("a range image is not what it says");
  }
  checkLengths(
      image.size(), {image.range_m.size(), image.azimuth_rad.size(), image.elevation_rad.size()},
      {image.time_s.size()});
}
}  // namespace

points::Decoded readScan(std::span<const uint8_t> bytes)
{
  Payload payload(bytes);
  points::Decoded decoded;
  takeScan(payload, decoded.scan);
  takeImage(payload, decoded.image);
  decoded.image.stamp = decoded.scan.stamp;
  decoded.image.sensor_label = decoded.scan.sensor_label;
  decoded.rejects.count = payload.take<decltype(decoded.rejects.count)>();
  payload.finish();
  return decoded;
}

CountFrame readCount(std::span<const uint8_t> bytes)
{
  Payload payload(bytes);
  CountFrame count;
  const auto what = payload.take<uint8_t>();
  if (what > static_cast<uint8_t>(Counted::note))
  {
    throw WireError("an unknown thing was counted");
  }
  count.what = static_cast<Counted>(what);
  count.type = payload.takeText();
  count.reason = payload.takeText();
  payload.finish();
  return count;
}

poses::StampedPose readPose(std::span<const uint8_t> bytes)
{
  Payload payload(bytes);
  poses::StampedPose pose;
  pose.time = payload.take<poses::TimeNs>();
  pose.T_map_base = payload.takePose();
  payload.finish();
  return pose;
}

DamageFrame readDamage(std::span<const uint8_t> bytes)
{
  Payload payload(bytes);
  DamageFrame damage;
  damage.not_a_log = payload.take<uint8_t>() != 0;
  damage.message = payload.takeText();
  payload.finish();
  return damage;
}

SightingFrame readSighting(std::span<const uint8_t> bytes)
{
  Payload payload(bytes);
  SightingFrame sighting;
  sighting.label = payload.takeText();
  sighting.type = payload.takeText();
  sighting.stamp = payload.take<poses::TimeNs>();
  sighting.T_base_sensor = payload.takePose();
  payload.finish();
  return sighting;
}
}  // namespace traverse::logs
