// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Metrics of pieces: read back and added up.
#include "metrics.h"
#include "metrics_json.h"

#include <traverse/formats/bytes.h>

#include <algorithm>

namespace traverse::app
{
namespace
{
using Counts = std::map<std::string, uint64_t>;

PieceMetrics pieceFrom(const Json& json)
{
  PieceMetrics piece;
  json.at("number").get_to(piece.number);
  json.at("of").get_to(piece.of);
  json.at("whole").get_to(piece.whole);
  json.at("log_entries").get_to(piece.log_entries);
  json.at("log_bytes").get_to(piece.log_bytes);
  json.at("log_crc32").get_to(piece.log_crc32);
  json.at("poses_crc32").get_to(piece.poses_crc32);
  json.at("log_problems").get_to(piece.log_problems);
  json.at("log_warnings").get_to(piece.log_warnings);
  if (piece.number < 1 || piece.number > piece.of)
  {
    throw formats::FormatError("is damaged: it is of a piece that is none");
  }
  return piece;
}

MapMetrics mapFrom(const Json& json)
{
  MapMetrics map;
  json.at("name").get_to(map.name);
  json.at("scans").get_to(map.scans);
  json.at("scans_without_pose").get_to(map.scans_no_pose);
  json.at("points").get_to(map.points);
  json.at("points_outside").get_to(map.outside);
  json.at("points_bad").get_to(map.bad_points);
  json.at("points_over_budget").get_to(map.over_budget);
  return map;
}

RunMetrics metricsFrom(const Json& json)
{
  RunMetrics m;
  m.piece = pieceFrom(json.at("piece"));
  json.at("rawlog").get_to(m.rawlog);
  json.at("objects").get_to(m.objects);
  m.observations = json.at("observations").get<Counts>();
  m.ignored = json.at("observations_ignored").get<Counts>();
  m.rejected = json.at("observations_rejected").get<Counts>();
  for (size_t i = 0; i < points::kRejectCount; ++i)
  {
    json.at("rejects").at(std::string(points::kRejectNames[i])).get_to(m.rejects.count[i]);
  }
  json.at("stamps").at("repeated").get_to(m.repeated_stamps);
  json.at("stamps").at("backward").get_to(m.backward_stamps);
  json.at("stamps").at("bad").get_to(m.bad_stamps);
  json.at("scans").get_to(m.scans);
  json.at("first_stamp_s").get_to(m.first_stamp_s);
  json.at("last_stamp_s").get_to(m.last_stamp_s);
  json.at("points").get_to(m.points);
  json.at("pose_source").get_to(m.pose_source);
  m.poses = json.at("poses").get<Counts>();
  m.pose_quality = json.at("pose_quality").get<Counts>();
  m.deskew = json.at("deskew").get<Counts>();
  for (const Json& map : json.at("maps"))
  {
    m.maps.push_back(mapFrom(map));
  }
  return m;
}

void add(Counts& to, const Counts& from)
{
  for (const auto& [key, count] : from)
  {
    to[key] += count;
  }
}

void add(std::vector<std::string>& to, const std::vector<std::string>& from)
{
  for (const std::string& text : from)
  {
    if (std::find(to.begin(), to.end(), text) == to.end())
    {
      to.push_back(text);
    }
  }
}

void add(MapMetrics& to, const MapMetrics& from)
{
  to.scans += from.scans;
  to.scans_no_pose += from.scans_no_pose;
  to.points += from.points;
  to.outside += from.outside;
  to.bad_points += from.bad_points;
  to.over_budget += from.over_budget;
}
}  // namespace

RunMetrics pieceFromJson(const std::string& text)
{
  try
  {
    const Json json = parsedMetrics(text);
    if (!json.is_object() || !json.contains("piece"))
    {
      throw formats::FormatError("is of no piece of a log: it was not made with --piece");
    }
    if (json.at("crc32").get<uint32_t>() != metricsChecksum(json))
    {
      throw formats::FormatError("is damaged: it does not match its CRC-32");
    }
    return metricsFrom(json);
  }
  catch (const Json::exception& e)
  {
    throw formats::FormatError(std::string("is damaged: ") + e.what());
  }
}

void addPiece(RunMetrics& sum, const RunMetrics& piece)
{
  add(sum.problems, piece.piece->log_problems);
  add(sum.warnings, piece.piece->log_warnings);
  sum.rawlog = piece.rawlog;
  sum.objects += piece.objects;
  add(sum.observations, piece.observations);
  add(sum.ignored, piece.ignored);
  add(sum.rejected, piece.rejected);
  sum.rejects += piece.rejects;
  sum.repeated_stamps += piece.repeated_stamps;
  sum.backward_stamps += piece.backward_stamps;
  sum.bad_stamps += piece.bad_stamps;
  if (piece.scans > 0)
  {
    sum.first_stamp_s = sum.scans == 0 ? piece.first_stamp_s : sum.first_stamp_s;
    sum.last_stamp_s = piece.last_stamp_s;
  }
  sum.scans += piece.scans;
  sum.points += piece.points;
  sum.pose_source = piece.pose_source;
  sum.poses = piece.poses;  // of the whole log, in each
  add(sum.pose_quality, piece.pose_quality);
  add(sum.deskew, piece.deskew);
  for (size_t i = 0; i < sum.maps.size() && i < piece.maps.size(); ++i)
  {
    add(sum.maps[i], piece.maps[i]);
  }
  ++sum.merged_pieces;
}
}  // namespace traverse::app
