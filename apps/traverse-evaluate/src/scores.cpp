// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scores.h"

#include <traverse/common_app/map_files.h>
#include <traverse/evaluation/cells.h>
#include <traverse/evaluation/verdicts.h>

#include <algorithm>
#include <fmt/format.h>
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

void compare(
    MapScores& scores,
    const layers::LayerSet& map,
    const TruthFolder& truth,
    const evaluation::ConfusionParams& params)
{
  scores.not_compared = otherClasses(map, truth.layers);
  if (!scores.not_compared.empty())
  {
    return;
  }
  evaluation::checkLattice(map, truth.layers);
  scores.confusion = evaluation::confusionOf(map, truth.layers, params);
  scores.obstacles = evaluation::obstacleScore(map, truth.layers, params);
  scores.states = evaluation::stateAgreement(map, truth.layers, params);
  scores.outlines =
      evaluation::outlineScores(map, withReturns(truth.outlines, scores.obstacles.seen));
  scores.verdicts = evaluation::verdicts(map, truth.layers, params);
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

std::optional<PathScores> scoresOfPath(
    const std::vector<poses::StampedPose>& found, const std::vector<poses::StampedPose>& truth)
{
  if (found.empty() || truth.empty())
  {
    return std::nullopt;
  }
  const evaluation::PosePairs pairs = evaluation::associate(found, truth);
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
  for (const std::filesystem::path& file : mapFiles(run))
  {
    scores.maps.push_back(scoresOfMap(file, truth, params));
  }
  scores.path = scoresOfPath(readTum(run / "trajectory.tum"), truth.trajectory);
  return scores;
}
}  // namespace traverse::app
