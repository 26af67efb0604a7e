// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "decoders.h"

namespace traverse::observations
{
points::Decoded decodeVelodyneScan(const Request& /*request*/)
{
  throw Refused("Velodyne packets are not decoded yet");
}
}  // namespace traverse::observations
