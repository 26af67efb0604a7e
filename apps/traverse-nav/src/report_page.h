// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/json_text.h>
#include <traverse/nav_app/closed_loop.h>

#include <string>

namespace traverse::app
{
/** report.html of a drive; `picture` is a PNG file's bytes, or empty. */
std::string reportPage(
    const NavSettings& settings,
    const Pilot& pilot,
    const DriveResult& result,
    const Json& metrics,
    const std::string& picture);
}  // namespace traverse::app
