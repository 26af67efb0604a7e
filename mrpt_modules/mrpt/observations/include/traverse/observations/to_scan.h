// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/observations/observation_params.h>
#include <traverse/points/decoded.h>

#include <filesystem>
#include <string>

namespace mrpt::obs
{
class CObservation;
}  // namespace mrpt::obs

namespace traverse::observations
{
/** What became of an observation. */
enum class Outcome : uint8_t
{
  scan,      //!< `decoded` is its scan (which may have no point)
  ignored,   //!< it is no range measurement, or its label was not asked for
  rejected,  //!< it should have been a scan; `reason` says why it is none
};

/** An observation as a scan, or why not. */
struct ScanResult
{
  Outcome outcome = Outcome::ignored;
  points::Decoded decoded;
  std::string reason;  //!< of a few words, the same for the same cause, so that it can be counted
};

/** Decodes an observation of any class of MRPT. Stamps that are no clock's become 0 (see toTime()).
 *
 * Files that the observation names are read only from within `image_folder` (no absolute names, no
 * "..", no links out of it), and released afterwards; where it is empty, from MRPT's lazy-load
 * folder. Never throws for what stands in an observation. */
ScanResult toScan(
    const mrpt::obs::CObservation& observation,
    const ObservationParams& params,
    const std::filesystem::path& image_folder = {});
}  // namespace traverse::observations
