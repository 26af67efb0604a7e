// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace traverse::formats
{
/** An output folder, as an index shows it. All texts may be hostile. */
struct RunEntry
{
  std::string folder;                //!< its name in the folder of the index
  std::string title;                 //!< empty: the folder's name
  std::string log;                   //!< what was mapped
  std::string state;                 //!< "complete", "partial: ...", "not a finished run: ..."
  bool good = false;                 //!< whole and without problems
  bool has_report = false;           //!< report.html is there
  std::string thumbnail;             //!< a PNG file's bytes; empty: none
  std::optional<double> recorded_s;  //!< stamp of the first scan, s since 1970
  std::optional<uint64_t> scans;
  std::optional<uint64_t> points;
  std::optional<double> seconds;
  std::optional<uint64_t> warnings;
};

/** How an index of ours begins: what says so of a file. */
std::string_view runIndexMark();

/** A page with a row per run, in the order given, that loads nothing: pictures are in it, reports
 * are linked by relative addresses. Columns are sorted by a click where scripts may run. `note`
 * stands above the table, where it is not empty. The same runs give the same bytes. */
std::string runIndex(
    const std::string& title, const std::vector<RunEntry>& runs, const std::string& note = {});

/** A small PNG of a PNG's bytes, at most this wide; nothing where they are no PNG of 8 bits of red,
 * green and blue, or one of more than 64 million pixels. */
std::optional<std::string> thumbnail(const std::string& png_bytes, int width_px);
}  // namespace traverse::formats
