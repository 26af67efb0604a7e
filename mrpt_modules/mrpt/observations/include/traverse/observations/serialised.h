// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservation.h>

#include <string>

namespace traverse::observations
{
/** The observation's bytes in a rawlog; made in memory, as MRPT's file streams hide a full disk. */
std::string serialised(const mrpt::obs::CObservation& observation);
}  // namespace traverse::observations
