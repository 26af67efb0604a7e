// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/json_text.h>
#include <traverse/nav_app/replay.h>

#include <cstdint>
#include <filesystem>

namespace traverse::app
{
/** What a drive measured, as metrics.json has it. */
Json driveMetrics(
    const NavSettings& settings,
    const Pilot& pilot,
    const DriveResult& result,
    double optimum_m,
    uint64_t seed);

/** What a replay did. */
Json replayMetrics(
    const NavSettings& settings,
    const Pilot& pilot,
    const ReplayResult& result,
    const std::filesystem::path& log);
}  // namespace traverse::app
