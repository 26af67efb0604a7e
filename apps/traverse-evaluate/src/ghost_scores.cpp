// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ghost_scores.h"

#include <traverse/evaluation/cells.h>
#include <traverse/evaluation/obstacles.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/geotiff_read.h>

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <stdexcept>
#include <utility>

namespace traverse::app
{
namespace
{
using Cells = std::set<std::pair<int32_t, int32_t>>;

/** Maps of states have another code for obstacles than those of classes. */
uint8_t obstacleCode(const layers::LayerSet& set)
{
  const auto found = std::find_if(
      set.legend.begin(), set.legend.end(),
      [](const layers::LegendEntry& entry) { return entry.name == "obstacle"; });
  return found == set.legend.end() ? evaluation::kObstacle : found->code;
}

/** The obstacles among these cells. */
evaluation::ObstacleFrame frameOf(
    const Snapshot& snapshot, const Cells& cells, const layers::LayerSet& truth)
{
  const layers::LayerSet set = formats::readGeoTiffs({snapshot.file});
  evaluation::ObstacleFrame frame{snapshot.time_s, {}};
  try
  {
    evaluation::checkLattice(set, truth);
    const auto classes = evaluation::viewOf<uint8_t>(set, set.class_layer);
    const uint8_t obstacle = obstacleCode(set);
    for (const auto& [x, y] : cells)
    {
      if (classes.at({x, y}) == obstacle)
      {
        frame.obstacles.push_back({x, y});
      }
    }
  }
  catch (const std::invalid_argument& e)
  {
    throw formats::FormatError(fmt::format("'{}': {}", snapshot.file.string(), e.what()));
  }
  return frame;
}
}  // namespace

std::optional<evaluation::GhostScore> ghostsOf(
    const std::string& map, const std::vector<Snapshot>& snapshots, const TruthFolder& truth)
{
  Cells cells;
  for (const evaluation::Departure& departure : truth.departures)
  {
    cells.emplace(departure.cell.x, departure.cell.y);
  }
  std::vector<evaluation::ObstacleFrame> frames;
  for (const Snapshot& snapshot : snapshots)
  {
    if (snapshot.map == map && !cells.empty())
    {
      frames.push_back(frameOf(snapshot, cells, truth.layers));
    }
  }
  if (frames.empty())
  {
    return std::nullopt;
  }
  return evaluation::ghostScore(frames, truth.departures);
}
}  // namespace traverse::app
