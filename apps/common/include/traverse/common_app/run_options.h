// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace traverse::app
{
/** What programs that make a folder of an ini and a seed are asked for. */
struct RunOptions
{
  std::filesystem::path ini;
  std::filesystem::path output;
  uint64_t seed = 1;
  std::vector<std::string> assignments;  //!< "SECTION.KEY=VALUE"
  bool check_config = false;
  bool print_defaults = false;
  bool force = false;
  bool quiet = false;
};

/** What such a program calls its ini, and says of it. */
struct RunOptionTexts
{
  std::string ini_name;
  std::string ini;
  std::string seed;
  std::string check_config;
  std::string print_defaults;
};

/** Options that write to `options`, which must outlive the parsing. */
void declare(CLI::App& cli, const RunOptionTexts& texts, RunOptions& options);

/** What options do not see one by one; throws CLI::RequiredError. */
void check(const RunOptionTexts& texts, const RunOptions& options);
}  // namespace traverse::app
