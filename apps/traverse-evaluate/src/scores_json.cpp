// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scores_json.h"

#include <traverse/common_app/json_text.h>

#include <algorithm>
#include <limits>

namespace traverse::app
{
namespace
{
Json confusionJson(const evaluation::Confusion& confusion)
{
  const evaluation::ClassScores scores = evaluation::scoresOf(confusion);
  Json json{{"cells", confusion.total()},     {"left_out", confusion.left_out},
            {"accuracy", scores.accuracy},    {"mean_accuracy", scores.mean_accuracy},
            {"by_class", Json::object()},     {"names", confusion.names()},
            {"truth_by_found", Json::array()}};
  for (const evaluation::ClassScore& s : scores.classes)
  {
    json["by_class"][s.name] = {
        {"truth_cells", s.truth_cells},
        {"found_cells", s.found_cells},
        {"right_cells", s.right_cells},
        {"recall", s.recall},
        {"precision", s.precision},
        {"f1", s.f1},
        {"iou", s.iou}};
  }
  for (size_t truth = 0; truth < confusion.names().size(); ++truth)
  {
    Json row = Json::array();
    for (size_t found = 0; found < confusion.names().size(); ++found)
    {
      row.push_back(confusion.cells(static_cast<uint8_t>(truth), static_cast<uint8_t>(found)));
    }
    json["truth_by_found"].push_back(std::move(row));
  }
  return json;
}

Json obstaclesJson(const evaluation::ObstacleScore& o)
{
  return {{"true_cells", o.true_cells},       {"found_cells", o.found_cells},
          {"cell_recall", o.cellRecall()},    {"objects", o.objects},
          {"found_objects", o.found_objects}, {"object_recall", o.objectRecall()},
          {"missed_objects", o.missed},       {"phantom_cells", o.phantom_cells},
          {"phantom_share", o.phantomShare()}};
}

Json statesJson(const evaluation::StateAgreement& s)
{
  return {
      {"free_agreement", s.freeAgreement()},
      {"occupied_agreement", s.occupiedAgreement()},
      {"known_share", s.knownShare()},
      {"truth_by_found", s.cells}};
}

Json outlinesJson(const evaluation::OutlineScores& o)
{
  std::vector<double> areas;
  std::vector<double> distances;
  Json things = Json::array();
  for (const evaluation::OutlineScore& s : o.things)
  {
    areas.push_back(s.area_error_m2);
    distances.push_back(s.hausdorff_m);
    things.push_back(
        {{"object", s.object},
         {"true_area_m2", s.true_area_m2},
         {"found_area_m2", s.found_area_m2},
         {"area_error_m2", s.area_error_m2},
         {"hausdorff_m", s.hausdorff_m}});
  }
  return {
      {"median_area_error_m2", medianOf(areas)},
      {"median_hausdorff_m", medianOf(distances)},
      {"clusters", o.clusters},
      {"foreign_clusters", o.foreign_clusters},
      {"not_found", o.not_found},
      {"things", std::move(things)}};
}

Json ghostsJson(const evaluation::GhostScore& g)
{
  const auto first_ghost = std::upper_bound(g.seconds.begin(), g.seconds.end(), 0.0);
  return {
      {"departures", g.seconds.size()},
      {"ghosts", g.seconds.end() - first_ghost},
      {"never_cleared", g.never_cleared},
      {"unseen", g.unseen},
      {"mean_s", g.mean_s()},
      {"p50_s", g.percentile_s(0.5)},
      {"p95_s", g.percentile_s(0.95)},
      {"worst_s", g.percentile_s(1)}};
}

Json occupancyJson(const evaluation::OccupancyScore& o)
{
  return {
      {"obstacles", o.obstacles},
      {"obstacle_recall", o.obstacleRecall()},
      {"false_obstacle_rate", o.falseObstacleRate()},
      {"false_ditch_rate", o.falseDitchRate()},
      {"free_iou", o.freeIou()},
      {"ditches", o.ditches},
      {"ditch_recall", o.ditchRecall()},
      {"ditch_as_free_rate", o.ditchAsFreeRate()},
      {"unknown_share_of_free", o.blindShare()}};
}

Json mapJson(const MapScores& map)
{
  Json json{{"file", map.file}};
  if (!map.not_compared.empty())
  {
    json["not_compared"] = map.not_compared;
    return json;
  }
  if (map.occupancy)
  {
    json["occupancy"] = occupancyJson(map.occupancy->plain);
    json["occupancy_strict"] = occupancyJson(map.occupancy->strict);
  }
  else
  {
    json["classes"] = confusionJson(map.confusion);
    json["obstacles"] = obstaclesJson(map.obstacles);
    json["states"] = statesJson(map.states);
    json["outlines"] = outlinesJson(map.outlines);
  }
  if (map.ghosts)
  {
    json["ghosts"] = ghostsJson(*map.ghosts);
  }
  return json;
}

Json relativeJson(const evaluation::RelativeError& error)
{
  return {
      {"distance_m", error.distance_m},
      {"pieces", error.pieces},
      {"translation_percent", error.translation_percent},
      {"rotation_deg_per_m", error.rotation_deg_per_m}};
}

Json pathJson(const PathScores& path)
{
  Json json{
      {"poses", path.poses},
      {"without_truth", path.without_truth},
      {"ate_m", path.absolute.rmse_m},
      {"ate_max_m", path.absolute.max_m},
      {"ate_from_start_m", path.absolute.from_start_m},
      {"ate_as_they_are_m", path.absolute.as_they_are_m},
      {"step", relativeJson(path.step)},
      {"rpe", Json::array()}};
  for (const evaluation::RelativeError& error : path.relative)
  {
    json["rpe"].push_back(relativeJson(error));
  }
  return json;
}
}  // namespace

double medianOf(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string scoresJson(const Scores& scores)
{
  Json json{{"run", scores.run}, {"truth", scores.truth}, {"maps", Json::array()}};
  for (const MapScores& map : scores.maps)
  {
    json["maps"].push_back(mapJson(map));
  }
  if (scores.path)
  {
    json["trajectory"] = pathJson(*scores.path);
  }
  return textOf(json) + "\n";
}
}  // namespace traverse::app
