// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "judged_cells.h"

#include <traverse/evaluation/obstacles.h>
#include <traverse/evaluation/verdicts.h>

namespace traverse::evaluation
{
namespace
{
Verdict verdictOf(uint8_t truth, uint8_t found)
{
  if (found == truth)
  {
    return Verdict::right;
  }
  if (found == 0)
  {
    return Verdict::undefined;
  }
  if (truth == kObstacle)
  {
    return Verdict::missed_obstacle;
  }
  if (found == kObstacle)
  {
    return Verdict::false_obstacle;
  }
  return found < truth ? Verdict::too_easy : Verdict::too_rough;
}
}  // namespace

layers::LayerSet verdicts(
    const layers::LayerSet& map, const layers::LayerSet& truth, const ConfusionParams& params)
{
  const JudgedCells cells(map, truth, params);
  std::vector<uint8_t> codes;
  codes.reserve(truth.size());
  forEachCell(
      truth.extent,
      [&](geometry::CellIndex c)
      {
        const Verdict verdict =
            cells.judged(c) ? verdictOf(cells.truth(c), cells.found(c)) : Verdict::not_judged;
        codes.push_back(static_cast<uint8_t>(verdict));
      });
  layers::LayerSet set;
  set.lattice = truth.lattice;
  set.extent = truth.extent;
  set.class_layer = "verdict";
  // of Okabe and Ito's colours, which most people can tell apart
  set.legend = {
      {0, "not judged", {255, 255, 255}},
      {1, "right", {205, 220, 230}},
      {2, "missed obstacle", {213, 94, 0}},
      {3, "false obstacle", {240, 190, 0}},
      {4, "easier than true", {204, 121, 167}},
      {5, "rougher than true", {0, 114, 178}},
      {6, "undefined", {60, 60, 60}}};
  set.layers.push_back({"verdict", "1", std::move(codes)});
  return set;
}
}  // namespace traverse::evaluation
