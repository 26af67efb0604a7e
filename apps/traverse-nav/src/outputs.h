// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/json_text.h>
#include <traverse/formats/output_folder.h>
#include <traverse/nav_app/closed_loop.h>

#include <vector>

namespace traverse::app
{
/** trajectory.tum, drive.csv, decisions.csv, costs.png, report.html, metrics.json. Throws
 * formats::FileError. */
void writeDrive(
    formats::OutputFolder& folder,
    const NavSettings& settings,
    const Pilot& pilot,
    const std::vector<navigation::Goal>& goals,
    const DriveResult& result,
    const Json& metrics);
}  // namespace traverse::app
