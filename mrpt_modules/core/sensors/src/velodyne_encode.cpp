// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sensors/velodyne_encode.h>

#include <cmath>

namespace traverse::sensors
{
namespace
{
/** Writes little-endian numbers one after the other. */
class Writer
{
 public:
  explicit Writer(std::span<uint8_t> bytes) : bytes_(bytes) {}

  void put8(uint8_t value) { bytes_[at_++] = value; }

  void put16(uint16_t value)
  {
    put8(static_cast<uint8_t>(value & 0xFFU));
    put8(static_cast<uint8_t>(value >> 8U));
  }

 private:
  std::span<uint8_t> bytes_;
  size_t at_ = 0;
};

uint8_t factoryByteOf(VelodyneModel model)
{
  constexpr std::array<uint8_t, kVelodyneModels> kBytes = {0x21, 0x22, 0x28};
  return kBytes.at(static_cast<size_t>(model));
}
}  // namespace

std::array<uint8_t, kVelodynePacketBytes> encodeVelodyne(const VelodynePacketContent& content)
{
  std::array<uint8_t, kVelodynePacketBytes> bytes{};
  Writer writer(bytes);
  for (const VelodyneBlock& block : content.blocks)
  {
    writer.put16(0xEEFF);
    writer.put16(block.azimuth);
    for (const VelodyneReturn& record : block.records)
    {
      writer.put16(record.distance);
      writer.put8(record.intensity);
    }
  }
  writer.put16(static_cast<uint16_t>(content.time_us & 0xFFFFU));
  writer.put16(static_cast<uint16_t>(content.time_us >> 16U));
  writer.put8(static_cast<uint8_t>(content.mode));
  writer.put8(factoryByteOf(content.model));
  return bytes;
}

uint16_t countOfDistance(double distance_m, double distance_unit_m)
{
  const double count = std::floor(distance_m / distance_unit_m + 0.5);
  return count >= 1 && count <= 65535 ? static_cast<uint16_t>(count) : uint16_t{0};
}
}  // namespace traverse::sensors
