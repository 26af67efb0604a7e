// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "truth_section.h"

#include "scores_json.h"

#include <traverse/formats/png.h>

#include <cmath>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
std::string percent(double share)
{
  constexpr double kPercent = 100;
  return std::isfinite(share) ? fmt::format("{:.1f} %", kPercent * share) : "-";
}

std::string metres(double value)
{
  return std::isfinite(value) ? fmt::format("{:.3f} m", value) : "-";
}

std::string count(uint64_t n)
{
  return formats::readableNumber(static_cast<double>(n));
}

formats::Table classTable(const evaluation::ClassScores& scores)
{
  formats::Table table{
      "Accuracy: share of a class's true cells that were found as such. Precision: share of the "
      "cells found as such that are.",
      {"class", "accuracy", "precision", "F1", "IoU", "true cells", "found cells"},
      {}};
  for (const evaluation::ClassScore& s : scores.classes)
  {
    table.rows.push_back(
        {s.name, percent(s.recall), percent(s.precision), percent(s.f1), percent(s.iou),
         count(s.truth_cells), count(s.found_cells)});
  }
  return table;
}

formats::Table confusionTable(const evaluation::Confusion& confusion)
{
  formats::Table table{"Cells by true class (rows) and class found (columns)", {"true"}, {}};
  const std::vector<std::string>& names = confusion.names();
  table.head.insert(table.head.end(), names.begin(), names.end());
  for (size_t truth = 1; truth < names.size(); ++truth)
  {
    std::vector<std::string> row = {names[truth]};
    for (size_t found = 0; found < names.size(); ++found)
    {
      row.push_back(
          count(confusion.cells(static_cast<uint8_t>(truth), static_cast<uint8_t>(found))));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

formats::Table obstacleTable(const MapScores& map)
{
  std::vector<double> distances;
  std::vector<double> areas;
  for (const evaluation::OutlineScore& s : map.outlines.things)
  {
    distances.push_back(s.hausdorff_m);
    areas.push_back(s.area_error_m2);
  }
  const evaluation::ObstacleScore& o = map.obstacles;
  const double area = medianOf(areas);
  return {
      "Obstacles, and what is free",
      {"what", "value"},
      {{"true obstacle cells that were found", percent(o.cellRecall())},
       {"things with a cell found at least", count(o.found_objects) + " of " + count(o.objects)},
       {"obstacle cells farther than a cell from any true one", percent(o.phantomShare())},
       {"true free cells that are free, of those known", percent(map.states.freeAgreement())},
       {"true occupied cells that are occupied, of those known",
        percent(map.states.occupiedAgreement())},
       {"cells of the truth that the map knows", percent(map.states.knownShare())},
       {"farthest place of a thing's outline from the cells found, median",
        metres(medianOf(distances))},
       {"area of a thing in one of map and truth only, median",
        std::isfinite(area) ? fmt::format("{:.2f} m\u00B2", area) : "-"}}};
}

std::string seconds(double value)
{
  return std::isfinite(value) ? fmt::format("{:.2f} s", value) : "-";
}

formats::Table ghostTable(const evaluation::GhostScore& ghosts)
{
  return {
      "How long cells stay obstacles when what moves has left them (0 s: not at all)",
      {"what", "value"},
      {{"cells left, of which the map was seen again", count(ghosts.seconds.size())},
       {"half of them, at most", seconds(ghosts.percentile_s(0.5))},
       {"95 % of them, at most", seconds(ghosts.percentile_s(0.95))},
       {"the worst", seconds(ghosts.percentile_s(1))},
       {"still obstacles at the end, or when something came again", count(ghosts.never_cleared)}}};
}

formats::Table occupancyTable(const OccupancyScores& scores)
{
  const auto row = [&](const std::string& what, auto figure)
  {
    return std::vector<std::string>{
        what, percent((scores.plain.*figure)()), percent((scores.strict.*figure)())};
  };
  using Score = evaluation::OccupancyScore;
  return {
      "Obstacles, ditches, and what is free",
      {"what", "within a cell", "cell by cell"},
      {row("true obstacle cells that were found, of those known", &Score::obstacleRecall),
       row("true free cells that are obstacles, of those known", &Score::falseObstacleRate),
       row("true free cells that are ditches, of those known", &Score::falseDitchRate),
       row("free in both, of what is free in one of map and truth", &Score::freeIou),
       row("true ditch cells that were found", &Score::ditchRecall),
       row("true ditch cells that are free", &Score::ditchAsFreeRate),
       row("true free cells that are unknown", &Score::blindShare)}};
}

void addOccupancy(formats::Section& section, const MapScores& map)
{
  section.blocks.emplace_back(formats::Paragraph{
      map.file + ": " + count(map.occupancy->plain.obstacles) + " true obstacle cells and " +
      count(map.occupancy->plain.known_free) + " true free cells judged."});
  section.blocks.emplace_back(occupancyTable(*map.occupancy));
}

void addClasses(formats::Section& section, const MapScores& map)
{
  const evaluation::ClassScores scores = evaluation::scoresOf(map.confusion);
  section.blocks.emplace_back(formats::Paragraph{
      map.file + ": " + count(map.confusion.total()) + " cells judged, " +
      count(map.confusion.left_out) +
      " left out (too few points, no truth, or under something "
      "that moved)."});
  section.blocks.emplace_back(formats::KeyFigures{
      {{"mean accuracy", percent(scores.mean_accuracy)},
       {"right cells", percent(scores.accuracy)},
       {"obstacles found", percent(map.obstacles.objectRecall())},
       {"phantoms", percent(map.obstacles.phantomShare())}}});
  section.blocks.emplace_back(formats::Picture{
      formats::png(formats::classPicture(map.verdicts)),
      "Where the map is wrong, from above, north up.", true});
  section.blocks.emplace_back(formats::Legend{map.verdicts.legend});
  section.blocks.emplace_back(classTable(scores));
  section.blocks.emplace_back(confusionTable(map.confusion));
  section.blocks.emplace_back(obstacleTable(map));
}

void addMap(formats::Section& section, const MapScores& map)
{
  if (!map.not_compared.empty())
  {
    section.blocks.emplace_back(
        formats::Notice{map.file + " was not compared: " + map.not_compared});
    return;
  }
  if (map.occupancy)
  {
    addOccupancy(section, map);
  }
  else
  {
    addClasses(section, map);
  }
  if (map.ghosts)
  {
    section.blocks.emplace_back(ghostTable(*map.ghosts));
  }
}

std::vector<std::string> relativeRow(const std::string& what, const evaluation::RelativeError& e)
{
  const auto number = [](double v) { return std::isfinite(v) ? fmt::format("{:.3f}", v) : "-"; };
  return {what, number(e.translation_percent), number(e.rotation_deg_per_m), count(e.pieces)};
}

void addPath(formats::Section& section, const PathScores& path)
{
  section.blocks.emplace_back(formats::KeyFigures{
      {{"ATE, aligned", metres(path.absolute.rmse_m)},
       {"ATE, from the start", metres(path.absolute.from_start_m)},
       {"ATE, as they are", metres(path.absolute.as_they_are_m)},
       {"poses", count(path.poses)}}});
  formats::Table table{
      "Errors of the poses over pieces of the way",
      {"piece", "translation, %", "rotation, deg/m", "pieces"},
      {}};
  table.rows.push_back(relativeRow("from pose to pose", path.step));
  for (const evaluation::RelativeError& error : path.relative)
  {
    table.rows.push_back(relativeRow(fmt::format("{:g} m", error.distance_m), error));
  }
  section.blocks.emplace_back(std::move(table));
}
}  // namespace

formats::Section truthSection(const Scores& scores)
{
  formats::Section section{"Against the truth", {}};
  for (const MapScores& map : scores.maps)
  {
    addMap(section, map);
  }
  if (scores.path)
  {
    addPath(section, *scores.path);
  }
  return section;
}
}  // namespace traverse::app
