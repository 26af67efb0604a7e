// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/sensors/velodyne_packet.h>
#include <traverse/sensors/velodyne_timing.h>

#include <algorithm>

namespace traverse::sensors
{
namespace
{
constexpr size_t kBlockBytes = 100;
constexpr size_t kAzimuthAt = 2;  // in a block, after its id
constexpr size_t kTimeAt = 1200;  // in the packet
constexpr size_t kModeAt = 1204;
constexpr size_t kModelAt = 1205;
constexpr uint16_t kBlockId = 0xEEFF;
constexpr uint16_t kHundredthsPerTurn = 36000;

uint16_t uint16At(VelodynePacket bytes, size_t at)
{
  return static_cast<uint16_t>(bytes[at] | bytes[at + 1] << 8);
}

uint32_t uint32At(VelodynePacket bytes, size_t at)
{
  return uint32_t{uint16At(bytes, at)} | uint32_t{uint16At(bytes, at + 2)} << 16;
}

size_t blockAt(int block)
{
  return static_cast<size_t>(block) * kBlockBytes;
}

std::optional<VelodyneModel> modelOf(uint8_t factory_byte)
{
  switch (factory_byte)
  {
    case 0x21:
      return VelodyneModel::hdl32e;
    case 0x22:
      return VelodyneModel::vlp16;
    case 0x28:
      return VelodyneModel::vlp32c;
    default:
      return std::nullopt;
  }
}

std::optional<ReturnMode> modeOf(uint8_t factory_byte)
{
  if (factory_byte < 0x37 || factory_byte > 0x39)
  {
    return std::nullopt;
  }
  return static_cast<ReturnMode>(factory_byte);
}

bool isBlock(VelodynePacket bytes, int block)
{
  return uint16At(bytes, blockAt(block)) == kBlockId &&
         uint16At(bytes, blockAt(block) + kAzimuthAt) < kHundredthsPerTurn;
}

/** The sensors turn at 20 Hz at most; twice that is a fault, not a turn. */
bool isPlausibleStep(int step_hundredths, VelodyneModel model)
{
  constexpr int64_t kMaxTurnsPerSecond = 40;
  constexpr int64_t kNsPerSecond = 1'000'000'000;
  return step_hundredths * kNsPerSecond <=
         kMaxTurnsPerSecond * kHundredthsPerTurn * timingOf(model).blockNs();
}
}  // namespace

std::optional<VelodyneData> VelodyneData::check(VelodynePacket bytes)
{
  if (bytes.size() != kVelodynePacketBytes)
  {
    return std::nullopt;
  }
  const auto model = modelOf(bytes[kModelAt]);
  const auto mode = modeOf(bytes[kModeAt]);
  if (!model || !mode)
  {
    return std::nullopt;
  }
  for (int block = 0; block < kVelodyneBlocks; ++block)
  {
    if (!isBlock(bytes, block))
    {
      return std::nullopt;
    }
  }
  VelodyneData data;
  data.bytes_ = bytes;
  data.model_ = *model;
  data.mode_ = *mode;
  data.time_us_ = uint32At(bytes, kTimeAt);
  for (int block = 0; block < kVelodyneBlocks; ++block)
  {
    if (uint16At(bytes, blockAt(block) + kAzimuthAt) != data.azimuth(block / data.blocksPerGroup()))
    {
      return std::nullopt;
    }
  }
  return data;
}

uint16_t VelodyneData::azimuth(int group) const
{
  return uint16At(bytes_, blockAt(group * blocksPerGroup()) + kAzimuthAt);
}

std::optional<uint16_t> VelodyneData::ownStep(int group) const
{
  if (group < 0 || group + 1 >= groups())
  {
    return std::nullopt;
  }
  const int step = (azimuth(group + 1) - azimuth(group) + kHundredthsPerTurn) % kHundredthsPerTurn;
  if (!isPlausibleStep(step, model_))
  {
    return std::nullopt;
  }
  return static_cast<uint16_t>(step);
}

uint16_t VelodyneData::azimuthStep(int group) const
{
  for (int distance = 0; distance < groups(); ++distance)
  {
    for (const int neighbour : {group - distance, group + distance})
    {
      if (const auto step = ownStep(neighbour))
      {
        return *step;
      }
    }
  }
  return 0;
}
}  // namespace traverse::sensors
