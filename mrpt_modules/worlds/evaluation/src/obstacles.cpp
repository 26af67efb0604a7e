// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "judged_cells.h"

#include <traverse/evaluation/obstacles.h>

#include <algorithm>
#include <map>

namespace traverse::evaluation
{
namespace
{
constexpr uint32_t kGround = 1;

bool obstacleNear(const CellView<uint8_t>& truth, geometry::CellIndex c)
{
  for (int32_t dy = -1; dy <= 1; ++dy)
  {
    for (int32_t dx = -1; dx <= 1; ++dx)
    {
      if (truth.at({c.x + dx, c.y + dy}) == kObstacle)
      {
        return true;
      }
    }
  }
  return false;
}

FoundState stateOf(uint8_t found)
{
  if (found == 0)
  {
    return FoundState::unknown;
  }
  return found == kObstacle ? FoundState::occupied : FoundState::free;
}

/** Of two columns of the table's rows a and b: what is in `column`, of what is known. */
double agreement(const StateAgreement& states, size_t a, size_t b, FoundState wanted)
{
  const auto free = static_cast<size_t>(FoundState::free);
  const auto occupied = static_cast<size_t>(FoundState::occupied);
  const auto column = static_cast<size_t>(wanted);
  const uint64_t known = states.cells[a][free] + states.cells[a][occupied] + states.cells[b][free] +
                         states.cells[b][occupied];
  return share(states.cells[a][column] + states.cells[b][column], known);
}
}  // namespace

double ObstacleScore::cellRecall() const
{
  return share(found_cells, true_cells);
}

double ObstacleScore::objectRecall() const
{
  return share(found_objects, objects);
}

double ObstacleScore::phantomShare() const
{
  return share(phantom_cells, map_cells);
}

ObstacleScore obstacleScore(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params)
{
  const JudgedCells cells(map, truth, params);
  const auto objects = viewOf<uint32_t>(truth, "truth_object");
  ObstacleScore score;
  std::map<uint32_t, bool> found_by_object;
  forEachCell(
      truth.extent,
      [&](geometry::CellIndex c)
      {
        if (!cells.judged(c))
        {
          return;
        }
        const bool found = cells.found(c) == kObstacle;
        if (cells.truth(c) == kObstacle)
        {
          ++score.true_cells;
          score.found_cells += found ? 1 : 0;
          bool& any = found_by_object[objects.at(c)];
          any = any || found;
        }
        if (found)
        {
          ++score.map_cells;
          score.phantom_cells += obstacleNear(cells.truth(), c) ? 0 : 1;
        }
      });
  std::erase_if(found_by_object, [](const auto& one) { return one.first <= kGround; });
  score.objects = found_by_object.size();
  for (const auto& [object, any] : found_by_object)
  {
    score.seen.push_back(object);
    score.found_objects += any ? 1 : 0;
    if (!any)
    {
      score.missed.push_back(object);
    }
  }
  return score;
}

double StateAgreement::freeAgreement() const
{
  return agreement(*this, 1, 3, FoundState::free);
}

double StateAgreement::occupiedAgreement() const
{
  return agreement(*this, 2, 4, FoundState::occupied);
}

double StateAgreement::knownShare() const
{
  uint64_t known = 0;
  uint64_t all = 0;
  for (size_t is = 1; is < kTrueStates; ++is)
  {
    known += cells[is][1] + cells[is][2];
    all += cells[is][0] + cells[is][1] + cells[is][2];
  }
  return share(known, all);
}

StateAgreement stateAgreement(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params)
{
  const JudgedCells cells(map, truth, params);
  const auto states = viewOf<uint8_t>(truth, "truth_state");
  StateAgreement agreement;
  forEachCell(
      truth.extent,
      [&](geometry::CellIndex c)
      {
        const size_t is = states.at(c);
        if (is < StateAgreement::kTrueStates && !cells.leftOut(c))
        {
          ++agreement.cells[is][static_cast<size_t>(stateOf(cells.found(c)))];
        }
      });
  return agreement;
}
}  // namespace traverse::evaluation
