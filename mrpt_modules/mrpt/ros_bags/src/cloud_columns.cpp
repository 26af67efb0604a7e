// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_columns.h"

#include <traverse/formats/bytes.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>

namespace traverse::ros_bags
{
namespace
{
enum FieldType : uint8_t
{
  kInt8 = 1,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64,
};

template <class T>
T numberAt(const char* at, bool swapped)
{
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (swapped)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  return std::bit_cast<T>(bytes);
}

/** A field of a cloud, point by point; the cloud's own checks hold (parsePointCloud). */
class Column
{
 public:
  Column(const PointCloud& cloud, const PointField& field) : cloud_(cloud), field_(field) {}

  uint8_t type() const { return field_.type; }

  const std::string& name() const { return field_.name; }

  /** Calls f(const char*, bool swapped) for each point. */
  template <class F>
  void each(F&& f) const
  {
    for (size_t row = 0; row < cloud_.height; ++row)
    {
      const char* at = cloud_.data.data() + row * cloud_.row_step + field_.offset;
      for (size_t i = 0; i < cloud_.width; ++i, at += cloud_.point_step)
      {
        f(at, cloud_.big_endian);
      }
    }
  }

  template <class T>
  std::vector<double> as() const
  {
    std::vector<double> values;
    values.reserve(size_t{cloud_.width} * cloud_.height);
    each([&](const char* at, bool swapped)
         { values.push_back(static_cast<double>(numberAt<T>(at, swapped))); });
    return values;
  }

  std::vector<double> values() const
  {
    switch (field_.type)
    {
      case kInt8:
        return as<int8_t>();
      case kUint8:
        return as<uint8_t>();
      case kInt16:
        return as<int16_t>();
      case kUint16:
        return as<uint16_t>();
      case kInt32:
        return as<int32_t>();
      case kUint32:
        return as<uint32_t>();
      case kFloat32:
        return as<float>();
      default:
        return as<double>();
    }
  }

  std::vector<float> floats() const
  {
    std::vector<float> values;
    const std::vector<double> wide = this->values();
    values.reserve(wide.size());
    constexpr double kMost = std::numeric_limits<float>::max();
    for (const double v : wide)
    {
      const bool fits = std::abs(v) <= kMost;
      values.push_back(fits ? static_cast<float>(v) : std::numeric_limits<float>::quiet_NaN());
    }
    return values;
  }

 private:
  const PointCloud& cloud_;
  const PointField& field_;
};

const PointField* findField(const PointCloud& cloud, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    for (const PointField& field : cloud.fields)
    {
      if (field.name == name)
      {
        return &field;
      }
    }
  }
  return nullptr;
}

void readIntensity(const PointCloud& cloud, CloudColumns& out)
{
  const PointField* field =
      findField(cloud, {"intensity", "intensities", "reflectivity", "reflectance", "i"});
  if (field == nullptr)
  {
    return;
  }
  out.intensity = Column(cloud, *field).floats();
  const bool byte = field->type == kUint8 || field->type == kInt8;
  const bool word = field->type == kUint16 || field->type == kInt16;
  out.intensity_full = byte ? 255.0F : (word ? 65535.0F : 0.0F);
}

void readRing(const PointCloud& cloud, CloudColumns& out)
{
  const PointField* field = findField(cloud, {"ring", "channel", "line", "laser_id", "laserid"});
  if (field == nullptr)
  {
    return;
  }
  std::vector<uint16_t> rings;
  const std::vector<double> values = Column(cloud, *field).values();
  rings.reserve(values.size());
  for (const double v : values)
  {
    if (!(v >= 0 && v <= std::numeric_limits<uint16_t>::max()))
    {
      out.notes.push_back("its field '" + field->name + "' holds values that are no rings");
      return;
    }
    rings.push_back(static_cast<uint16_t>(v));
  }
  out.channels.ring = std::move(rings);
}

/** Seconds per unit of absolute times of this magnitude; 0: they are no times since 1970. */
double absoluteUnit(double value)
{
  constexpr double kFrom_s = 1e8;  // 1973; so for each unit, with room up to the next
  constexpr double kNano = 1e-9;
  constexpr double kMicro = 1e-6;
  constexpr double kMilli = 1e-3;
  for (const double unit : {kNano, kMicro, kMilli, 1.0})
  {
    if (value * unit >= kFrom_s)
    {
      return unit;
    }
  }
  return 0;
}

/** Integers are nanoseconds, floating point are seconds, unless their size says that they count
 * from 1970. */
double relativeTime(double value, bool integer, int64_t stamp_ns)
{
  constexpr double kNsPerS = 1e9;
  if (integer)
  {
    return value / kNsPerS;
  }
  const double unit = absoluteUnit(value);
  return unit == 0 ? value : value * unit - static_cast<double>(stamp_ns) / kNsPerS;
}

void readTime(const PointCloud& cloud, int64_t stamp_ns, CloudColumns& out)
{
  const PointField* field = findField(
      cloud, {"time", "t", "timestamp", "time_stamp", "offset_time", "time_offset", "timeoffset",
              "offset"});
  if (field == nullptr)
  {
    return;
  }
  const bool integer = field->type < kFloat32;
  std::vector<float> times;
  const std::vector<double> values = Column(cloud, *field).values();
  times.reserve(values.size());
  for (size_t i = 0; i < values.size(); ++i)
  {
    constexpr double kLongest_s = 10;
    const double t = relativeTime(values[i], integer, stamp_ns);
    const bool no_point = !std::isfinite(out.x[i]);  // drivers leave the rest of such unset
    if (!(std::abs(t) <= kLongest_s) && !no_point)
    {
      out.notes.push_back("its field '" + field->name + "' holds values that are no times");
      return;
    }
    times.push_back(std::abs(t) <= kLongest_s ? static_cast<float>(t) : 0.0F);
  }
  out.channels.time_s = std::move(times);
}

void readColour(const PointCloud& cloud, CloudColumns& out)
{
  if (const PointField* packed = findField(cloud, {"rgb", "rgba"}))
  {
    if (packed->type != kFloat32 && packed->type != kUint32 && packed->type != kInt32)
    {
      out.notes.push_back("its field '" + packed->name + "' is no packed colour");
      return;
    }
    constexpr uint32_t kColour = 0xff'ffff;
    Column(cloud, *packed)
        .each([&](const char* at, bool swapped)
              { out.rgb.push_back(numberAt<uint32_t>(at, swapped) & kColour); });
    return;
  }
  const std::array<const PointField*, 3> parts = {
      findField(cloud, {"r"}), findField(cloud, {"g"}), findField(cloud, {"b"})};
  const auto is_byte = [](const PointField* f) { return f != nullptr && f->type == kUint8; };
  if (!std::all_of(parts.begin(), parts.end(), is_byte))
  {
    return;
  }
  out.rgb.assign(size_t{cloud.width} * cloud.height, 0);
  for (const PointField* part : parts)
  {
    auto to = out.rgb.begin();
    Column(cloud, *part)
        .each([&](const char* at, bool swapped)
              { *to = *to << 8U | numberAt<uint8_t>(at, swapped), ++to; });
  }
}
}  // namespace

CloudColumns readColumns(const PointCloud& cloud, int64_t stamp_ns)
{
  CloudColumns out;
  for (const auto& [name, to] : std::initializer_list<std::pair<const char*, std::vector<float>*>>{
           {"x", &out.x}, {"y", &out.y}, {"z", &out.z}})
  {
    const PointField* field = findField(cloud, {name});
    if (field == nullptr)
    {
      throw formats::FormatError(std::string("PointCloud2: has no field '") + name + "'");
    }
    *to = Column(cloud, *field).floats();
  }
  readIntensity(cloud, out);
  readRing(cloud, out);
  readTime(cloud, stamp_ns, out);
  readColour(cloud, out);
  return out;
}
}  // namespace traverse::ros_bags
