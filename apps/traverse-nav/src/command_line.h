// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>
#include <traverse/common_app/run_options.h>

#include <array>
#include <optional>

namespace traverse::app
{
struct NavCommand : RunOptions
{
  std::filesystem::path replay;              //!< a log; empty: the closed loop
  std::optional<std::array<double, 2>> why;  //!< a place: what do its costs consist of in the end?
};

Parsed<NavCommand> parseNavCommand(int argc, const char* const* argv);
}  // namespace traverse::app
