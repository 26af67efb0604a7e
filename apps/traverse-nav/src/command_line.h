// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace traverse::app
{
struct NavCommand
{
  std::filesystem::path config;
  std::filesystem::path output;
  uint64_t seed = 1;
  std::vector<std::string> assignments;
  std::optional<std::array<double, 2>> why;  //!< a place: what do its costs consist of in the end?
  bool check_config = false;
  bool print_defaults = false;
  bool force = false;
  bool quiet = false;
};

Parsed<NavCommand> parseNavCommand(int argc, const char* const* argv);
}  // namespace traverse::app
