// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>

#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** What the user asked for. */
struct InspectCommand
{
  std::filesystem::path input;              //!< a log, an archive, or an output folder
  std::vector<std::filesystem::path> diff;  //!< --diff: two maps
  double tolerance = 0;                     //!< of values, in each layer's unit
  double cells_tolerance = 0;               //!< share of cells that may differ, 0..1
  bool doctor = false;
  std::string poses;  //!< --poses: a source of the log, or a trajectory file; empty: what there is
  std::string times;  //!< --times: for a KITTI trajectory
  std::filesystem::path pictures;  //!< --pictures: folder of first clouds
  std::string why;                 //!< --why X,Y
  bool json = false;
  bool quiet = false;
};

/** Parses argv. */
Parsed<InspectCommand> parseInspectCommand(int argc, const char* const* argv);
}  // namespace traverse::app
