// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scores.h"

#include "ghost_scores.h"

#include <traverse/common_app/map_files.h>
#include <traverse/evaluation/cells.h>
#include <traverse/evaluation/verdicts.h>
#include <traverse/formats/bytes.h>

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <stdexcept>

namespace traverse::app
{
namespace
{
/** Why a map's classes are not those of the truth; empty where they are. */
std::string otherClasses(const layers::LayerSet& map, const layers::LayerSet& truth)
{
  if (map.class_layer.empty())
  {
    return "it has no classes";
  }
  for (const layers::LegendEntry& entry : map.legend)
  {
    const bool same = std::any_of(
        truth.legend.begin(), truth.legend.end(),
        [&](const layers::LegendEntry& t)
        { return entry.code == t.code && (entry.code == 0 || entry.name == t.name); });
    if (!same)
    {
      return fmt::format("its class '{}' is none of the truth's", entry.name);
    }
  }
  return "";
}

/** Things of which the map has returns enough to be judged by. */
std::vector<evaluation::TrueOutline> withReturns(
    const std::vector<evaluation::TrueOutline>& outlines, const std::vector<uint32_t>& seen)
{
  const std::set<uint32_t> numbers(seen.begin(), seen.end());
  std::vector<evaluation::TrueOutline> some;
  std::copy_if(
      outlines.begin(), outlines.end(), std::back_inserter(some),
      [&](const evaluation::TrueOutline& o) { return numbers.contains(o.object); });
  return some;
}

/** As outlineScores(); what is too much for it is a fault of the truth. */
evaluation::OutlineScores outlinesOf(
    const layers::LayerSet& map, const std::vector<evaluation::TrueOutline>& outlines)
{
  try
  {
    return evaluation::outlineScores(map, outlines);
  }
  catch (const std::length_error& e)
  {
    throw formats::FormatError(fmt::format("'footprints.geojson': {}", e.what()));
  }
}

/** Maps of states have no classes of roughness. */
bool isOfStates(const layers::LayerSet& map)
{
  return map.find("occupancy_state") != nullptr && map.find("traversability_class") == nullptr;
}

OccupancyScores occupancyOf(const layers::LayerSet& map, const layers::LayerSet& truth)
{
  OccupancyScores scores;
  evaluation::OccupancyParams params;
  params.ditch_radius_m = std::numeric_limits<double>::infinity();
  scores.plain = evaluation::occupancyScore(map, truth, params);
  params.tolerance_cells = 0;
  scores.strict = evaluation::occupancyScore(map, truth, params);
  return scores;
}

void compare(
    MapScores& scores,
    const layers::LayerSet& map,
    const TruthFolder& truth,
    const evaluation::ConfusionParams& params)
{
  if (isOfStates(map))
  {
    scores.occupancy = occupancyOf(map, truth.layers);
    scores.not_compared = scores.occupancy->plain.unknown_free == scores.occupancy->plain.free_cells
                              ? "it knows no cell of this truth"
                              : "";
    return;
  }
  scores.not_compared = otherClasses(map, truth.layers);
  if (!scores.not_compared.empty())
  {
    return;
  }
  evaluation::checkLattice(map, truth.layers);
  scores.confusion = evaluation::confusionOf(map, truth.layers, params);
  scores.obstacles = evaluation::obstacleScore(map, truth.layers, params);
  scores.states = evaluation::stateAgreement(map, truth.layers, params);
  scores.outlines = outlinesOf(map, withReturns(truth.outlines, scores.obstacles.seen));
  scores.verdicts = evaluation::verdicts(map, truth.layers, params);
  if (scores.confusion.total() == 0)
  {
    scores.not_compared = "it has no points in any cell of this truth";
  }
}

MapScores scoresOfMap(
    const std::filesystem::path& file,
    const TruthFolder& truth,
    const evaluation::ConfusionParams& params)
{
  const LoadedMap loaded = loadMap(file);
  MapScores scores;
  scores.file = file.filename().string();
  try
  {
    compare(scores, loaded.consumer->layerSet(truth.layers.extent), truth, params);
  }
  catch (const std::invalid_argument& e)  // cells of another size, layers of another type
  {
    scores.not_compared = e.what();
  }
  catch (const std::out_of_range& e)  // codes without a name
  {
    scores.not_compared = e.what();
  }
  return scores;
}

/** The same cells of another world would be compared without a word. */
void checkSameWorld(const evaluation::PosePairs& pairs)
{
  constexpr double kFarthest_m = 2;
  if (pairs.pairs.empty())
  {
    throw formats::FormatError(
        "the run's poses and the truth's are of different times: this is the truth of another "
        "log");
  }
  const evaluation::PosePair& first = pairs.pairs.front();
  const double apart_m = (first.found.translation() - first.truth.translation()).norm();
  if (apart_m > kFarthest_m)
  {
    throw formats::FormatError(fmt::format(
        "the run begins {:.1f} m from where the truth's vehicle was: this is the truth of another "
        "scene, or the run's poses are in another frame (as those of odometry)",
        apart_m));
  }
}

std::optional<PathScores> scoresOfPath(
    const std::vector<poses::StampedPose>& found, const std::vector<poses::StampedPose>& truth)
{
  if (found.empty() || truth.empty())
  {
    return std::nullopt;
  }
  const evaluation::PosePairs pairs = evaluation::associate(found, truth);
  checkSameWorld(pairs);
  return PathScores{
      pairs.pairs.size(), pairs.without_truth, evaluation::absoluteError(pairs.pairs),
      evaluation::relativeErrors(pairs.pairs, {1, 10, 50, 100}),
      evaluation::stepError(pairs.pairs)};
}
}  // namespace

bool Scores::anyCompared() const
{
  return std::any_of(
      maps.begin(), maps.end(), [](const MapScores& m) { return m.not_compared.empty(); });
}

Scores scoresOfRun(const std::filesystem::path& run, const TruthFolder& truth, uint32_t min_returns)
{
  evaluation::ConfusionParams params;
  params.min_returns = min_returns;
  Scores scores;
  scores.run = run.string();
  scores.path = scoresOfPath(readTum(run / "trajectory.tum"), truth.trajectory);
  const std::vector<Snapshot> snapshots = snapshotsOf(run);
  for (const std::filesystem::path& file : mapFiles(run))
  {
    scores.maps.push_back(scoresOfMap(file, truth, params));
    MapScores& map = scores.maps.back();
    if (map.not_compared.empty())
    {
      map.ghosts = ghostsOf(map.file, snapshots, truth);
    }
  }
  return scores;
}
}  // namespace traverse::app
