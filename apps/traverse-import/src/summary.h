// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/source.h>

#include <string>

namespace traverse::app
{
/** A text of the input, fit for a terminal: control characters and other bytes that are not ASCII
 * shown as ?, at most 300 bytes. */
std::string forTerminal(const std::string& text);

/** What was imported, by label and class; one line each. */
std::string summaryOf(const importing::ImportReport& report);

/** What was skipped and damaged, for stderr: bounded, whatever the input holds. */
void tellProblems(const importing::ImportReport& report);
}  // namespace traverse::app
