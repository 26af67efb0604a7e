// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings.h"

#include <traverse/formats/output_folder.h>

namespace traverse::app
{
/** moving.geojson; truth_*.tif and footprints.geojson for each of the times that [Truth] asks for;
 * all but the last time's have the time in their names ("truth_class_at_2.5_s.tif"). Throws
 * formats::FileError. */
void writeTruth(
    formats::OutputFolder& folder,
    const SimSettings& settings,
    const simulation::Recording& recording);
}  // namespace traverse::app
