// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/evaluation/departures.h>
#include <traverse/evaluation/outlines.h>
#include <traverse/layers/layer_set.h>
#include <traverse/poses/pose_track.h>

#include <filesystem>
#include <vector>

namespace traverse::app
{
/** What a truth folder says. */
struct TruthFolder
{
  layers::LayerSet layers;  //!< truth_class, truth_state, truth_object; truth_swept where it is
  std::vector<evaluation::TrueOutline> outlines;  //!< of things at least 25 cm high
  std::vector<poses::StampedPose> trajectory;     //!< empty: not told
  std::vector<evaluation::Departure> departures;  //!< of moving things from cells
};

/** truth_class.tif, truth_state.tif and truth_object.tif must be there; truth_swept.tif,
 * footprints.geojson, moving.geojson and trajectory.tum may be. Throws formats::FormatError, naming
 * the file. */
TruthFolder readTruth(const std::filesystem::path& folder);

/** A TUM file; empty where there is none. Throws formats::FormatError. */
std::vector<poses::StampedPose> readTum(const std::filesystem::path& file);
}  // namespace traverse::app
