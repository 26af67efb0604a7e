// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** What the command line of traverse-sim says. */
struct SimCommand
{
  std::filesystem::path scene;
  std::filesystem::path output;
  uint64_t seed = 1;
  int threads = 0;  //!< 0: as many as there are processors
  std::vector<std::string> assignments;
  bool check_config = false;
  bool print_defaults = false;
  bool force = false;
  bool quiet = false;
};

Parsed<SimCommand> parseSimCommand(int argc, const char* const* argv);
}  // namespace traverse::app
