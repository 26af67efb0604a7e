// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/navigation/path.h>

namespace traverse::navigation
{
/** What a car drives in the next 0.4 s, on the arc that it is on: a new path that began where it is
 * would begin with wheels that are not turned so yet. Empty below 0.2 m/s. */
Path leadIn(const geometry::Pose2& pose, const geometry::Twist2& motion);

/** `path`, which begins where `lead` ends, behind it. */
Path joined(Path lead, const Path& path);
}  // namespace traverse::navigation
