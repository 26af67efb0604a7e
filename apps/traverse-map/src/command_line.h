// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace traverse::app
{
/** Part `number` (from 1) of `of` parts of a log. */
struct Piece
{
  uint64_t number = 1;
  uint64_t of = 1;
};

/** What the user asked for. */
struct Command
{
  std::filesystem::path config;
  std::string rawlog;                        //!< instead of the ini's
  std::string output;                        //!< instead of the ini's
  std::vector<std::string> assignments;      //!< --set section.key=value
  std::optional<Piece> piece;                //!< --piece K/N
  std::filesystem::path point_labels;        //!< --point-labels: folder of label files
  std::vector<std::filesystem::path> merge;  //!< --merge: folders of pieces
  std::string rebuild;                       //!< --rebuild: an octree to map instead of a log
  std::string why;                           //!< --why X,Y; config is the output folder
  std::filesystem::path index;               //!< --index: folder of output folders
  bool check_config = false;
  bool print_defaults = false;
  bool print_options = false;
  bool force = false;
  bool quiet = false;
};

/** Parses argv. */
Parsed<Command> parseCommandLine(int argc, const char* const* argv);
}  // namespace traverse::app
