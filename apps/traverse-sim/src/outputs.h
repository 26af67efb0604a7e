// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part_store.h"
#include "settings.h"

#include <traverse/formats/output_folder.h>

#include <cstdint>
#include <map>
#include <string>

namespace traverse::app
{
/** What a run was, for messages and metrics.json. */
struct SimRun
{
  uint64_t seed = 1;
  size_t parts = 0;
  double duration_s = 0;
  std::map<std::string, uint64_t> observations;  //!< by their sensor's name
};

/** Writes everything into the folder, metrics.json last, and commits. Throws formats::FileError.
 * Returns what stdout shall say. */
std::string writeOutputs(
    formats::OutputFolder& folder,
    const PartStore& parts,
    const SimSettings& settings,
    const simulation::Recording& recording,
    const SimRun& run);
}  // namespace traverse::app
