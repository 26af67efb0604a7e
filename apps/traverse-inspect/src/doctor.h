// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"
#include "hint.h"

#include <traverse/common_app/json_text.h>
#include <traverse/logs/log_report.h>

#include <string>

namespace traverse::app
{
/** What the log says of its own set-up. */
struct Diagnosis
{
  logs::LogReport report;
  Hints hints;
};

/** Reads the log twice: its scans, then its poses. Throws logs::LogError, and formats::FormatError
 * for a trajectory file that cannot be read. */
Diagnosis examine(const InspectCommand& command);

/** For people: suspicions first. */
std::string hintsText(const Hints& hints);

Json hintsJson(const Hints& hints);
}  // namespace traverse::app
