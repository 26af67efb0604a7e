// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/common_app/parsed.h>
#include <traverse/importing/import_params.h>
#include <traverse/ros_bags/open_bag.h>

#include <filesystem>
#include <string>

namespace traverse::app
{
/** What the user asked for. */
struct ImportCommand
{
  importing::ImportParams params;
  ros_bags::BagParams bag;
  std::filesystem::path output;
  std::string format = "auto";
  bool force = false;
  bool quiet = false;
};

/** Parses argv. */
Parsed<ImportCommand> parseImportCommand(int argc, const char* const* argv);
}  // namespace traverse::app
