// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_census.h"

#include <traverse/common_app/json_text.h>
#include <traverse/logs/log_report.h>

#include <string>

namespace traverse::app
{
/** For people: observations by sensor, rates, gaps, order, poses; scans; what was rejected. */
std::string summaryText(
    const std::string& name, const logs::LogReport& report, const ScanCensus& census);

/** The same as one object. */
Json summaryJson(const std::string& name, const logs::LogReport& report, const ScanCensus& census);

/** "2011-09-26 13:02:25.594 UTC". */
std::string dateOf(poses::TimeNs time);

/** Text of a log, fit for a terminal: at most 60 bytes, '?' for what cannot be printed. */
std::string shown(const std::string& untrusted);

/** For the label of a sensor that may have none. */
std::string sensorName(const std::string& label, const std::string& type);
}  // namespace traverse::app
