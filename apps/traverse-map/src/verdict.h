// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "metrics.h"

#include <traverse/common_app/exit_code.h>
#include <traverse/observations/observation_params.h>

namespace traverse::app
{
/** Adds to the metrics' problems and warnings what a user must know of a run that did not take
 * everything. */
void noteWhatIsMissing(RunMetrics& metrics);

/** Warns of each label in [Sensors] sensor_labels that nothing in what was read of the log had. */
void noteAbsentLabels(const observations::ObservationParams& sensors, RunMetrics& metrics);

/** The exit code of a run that came to its end. */
ExitCode verdict(const RunMetrics& metrics);

/** The run has something to save: scans, or a piece of a log that has none in it. */
bool hasResults(const RunMetrics& metrics);
}  // namespace traverse::app
