// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>

#include <cstdint>
#include <filesystem>

namespace traverse::app
{
struct EvaluateCommand
{
  std::filesystem::path run;
  std::filesystem::path truth;
  std::filesystem::path output;  //!< empty: none
  uint32_t min_returns = 3;
  bool no_report = false;
};

Parsed<EvaluateCommand> parseEvaluateCommand(int argc, const char* const* argv);
}  // namespace traverse::app
