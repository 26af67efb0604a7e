// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "piece.h"

#include <traverse/common_app/interrupt.h>
#include <traverse/formats/bytes.h>
#include <traverse/formats/checksum.h>

#include <fmt/format.h>
#include <limits>

namespace traverse::app
{
namespace
{
uint32_t crc32Of(const poses::PoseTrack& track)
{
  formats::ByteWriter out;
  for (const poses::StampedPose& p : track.poses())
  {
    out.i64(p.time);
    for (int i = 0; i < p.T_map_base.matrix().size(); ++i)
    {
      out.f64(p.T_map_base.matrix().data()[i]);
    }
  }
  return formats::crc32(out.bytes());
}
}  // namespace

logs::EntryRange entriesOf(const Piece& piece, uint64_t log_entries)
{
  // By parts, as the product could overflow.
  const auto start_of = [&](uint64_t i)
  { return log_entries / piece.of * i + log_entries % piece.of * i / piece.of; };
  return {
      start_of(piece.number - 1),
      piece.number == piece.of ? std::numeric_limits<uint64_t>::max() : start_of(piece.number)};
}

void checkPieces(const Settings& settings, const std::vector<BuiltMap>& maps)
{
  if (settings.run.max_scans > 0)
  {
    throw config::ConfigError(
        "--piece: [traverse-map] max_scans must be 0, as a piece does not know how many scans the "
        "pieces before it have");
  }
  for (const BuiltMap& map : maps)
  {
    if (const std::string obstacle = map.consumer->mergeObstacle(); !obstacle.empty())
    {
      throw config::ConfigError(
          fmt::format("--piece: pieces of {} cannot be merged: {}", map.title(), obstacle));
    }
  }
}

PieceMetrics describePiece(
    const Settings& settings, const poses::PoseTrack& track, const RunMetrics& metrics)
{
  PieceMetrics piece;
  piece.number = settings.piece->number;
  piece.of = settings.piece->of;
  piece.log_entries =
      metrics.log_entries
          ? *metrics.log_entries
          : logs::countEntries(settings.rawlog, settings.log, {&Interrupt::flag(), false, {}})
                .objects;
  piece.log_bytes = std::filesystem::file_size(settings.rawlog);
  piece.log_crc32 = formats::crc32OfFile(settings.rawlog);
  piece.poses_crc32 = crc32Of(track);
  piece.log_problems = metrics.problems;
  piece.log_warnings = metrics.warnings;
  return piece;
}
}  // namespace traverse::app
