// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/logs/log_report.h>
#include <traverse/points/decoded.h>

#include <filesystem>
#include <functional>

namespace traverse::app
{
/** Gives every scan of a log, also those without a good stamp and however far its points are, with
 * progress on stderr; ends early at a signal. Throws logs::LogError. */
logs::LogReport readScans(
    const std::filesystem::path& log, bool quiet, const std::function<void(points::Decoded)>& give);
}  // namespace traverse::app
