// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "log_walk.h"

#include <traverse/observations/convert.h>

#include <mrpt/poses/CPose2D.h>
#include <mrpt/poses/CPosePDF.h>

#include <array>

namespace traverse::logs
{
namespace
{
constexpr int kOdometry = 0;  // TEstimationMethod::emOdometry

template <size_t N>
void skip(ObjectArchive& archive)
{
  std::array<uint8_t, N> unused{};
  archive.ReadBuffer(unused.data(), unused.size());
}

mrpt::poses::CPose2D readIncrement(ObjectArchive& archive, uint8_t version)
{
  const auto object = std::dynamic_pointer_cast<mrpt::poses::CPose2D>(archive.readWhole());
  if (!object)
  {
    throw LogDamage("an odometry action without its increment");
  }
  // The motion model: which one, 6 numbers of the Gaussian one, particles and 4 numbers of the
  // other one, from version 5 on 2 more of it.
  skip<(1 + 6 + 1 + 4) * 4>(archive);
  if (version >= 5)
  {
    skip<2 * 4>(archive);
  }
  return *object;
}

mrpt::poses::CPose2D readMean(ObjectArchive& archive)
{
  const auto object = std::dynamic_pointer_cast<mrpt::poses::CPosePDF>(archive.readWhole());
  if (!object)
  {
    throw LogDamage("a movement action without its increment");
  }
  return object->getMeanVal();
}

/** From version 7 on, speeds and ticks are stored only where there are any. */
void skipSpeedsAndTicks(ObjectArchive& archive, uint8_t version)
{
  const bool speeds = archive.ReadAs<uint8_t>() != 0;
  if (version < 7)
  {
    skip<2 * 4>(archive);
  }
  else if (speeds)
  {
    skip<3 * 8>(archive);
  }
  const bool ticks = archive.ReadAs<uint8_t>() != 0;
  if (version < 7 || ticks)
  {
    skip<2 * 4>(archive);
  }
}
}  // namespace

Movement readMovement2D(ObjectArchive& archive, const ObjectHeader& header)
{
  if (header.version < 4 || header.version > 7)
  {
    throw LogDamage(
        "a CActionRobotMovement2D of version " + std::to_string(header.version) +
        " (4 to 7 are understood)");
  }
  const bool odometry = archive.ReadAs<int32_t>() == kOdometry;
  const mrpt::poses::CPose2D step =
      odometry ? readIncrement(archive, header.version) : readMean(archive);
  skipSpeedsAndTicks(archive, header.version);
  Movement movement;
  if (header.version >= 6)
  {
    movement.stamp = observations::toTime(archive.ReadAs<mrpt::Clock::time_point>());
  }
  archive.readEndMark(header);
  movement.T_before_after = observations::toIsometry(step);
  return movement;
}
}  // namespace traverse::logs
