// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "truth_folder.h"

#include <traverse/evaluation/confusion.h>
#include <traverse/evaluation/ghosts.h>
#include <traverse/evaluation/obstacles.h>
#include <traverse/evaluation/occupancy_score.h>
#include <traverse/evaluation/outlines.h>
#include <traverse/evaluation/trajectory_errors.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace traverse::app
{
/** A map of states (layer occupancy_state) against truth_state. */
struct OccupancyScores
{
  evaluation::OccupancyScore plain;   //!< with one cell of tolerance
  evaluation::OccupancyScore strict;  //!< cell by cell
};

/** One map of a run against the truth. */
struct MapScores
{
  std::string file;
  std::string not_compared;                  //!< why; empty where it was
  std::optional<OccupancyScores> occupancy;  //!< of maps of states, which have no classes
  evaluation::Confusion confusion;
  evaluation::ObstacleScore obstacles;
  evaluation::StateAgreement states;
  evaluation::OutlineScores outlines;            //!< of things with returns
  std::optional<evaluation::GhostScore> ghosts;  //!< where there are snapshots and moving things
  layers::LayerSet verdicts;                     //!< of maps of classes
};

/** The run's poses against the true ones. */
struct PathScores
{
  size_t poses = 0;
  size_t without_truth = 0;
  evaluation::AbsoluteError absolute;
  std::vector<evaluation::RelativeError> relative;
  evaluation::RelativeError step;
};

struct Scores
{
  std::string run;
  std::string truth;
  std::vector<MapScores> maps;
  std::optional<PathScores> path;

  bool anyCompared() const;
};

/** Of all maps of an output folder. Needs plugin::registerAllMaps(). Throws formats::FormatError
 * for what cannot be read, and for a run that began elsewhere than the truth's vehicle. */
Scores scoresOfRun(
    const std::filesystem::path& run, const TruthFolder& truth, uint32_t min_returns);
}  // namespace traverse::app
