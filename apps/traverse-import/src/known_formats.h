// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.h"

#include <traverse/importing/source.h>

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace traverse::app
{
/** A layout as the app knows it: those of importing, and ROS bags. */
struct KnownFormat
{
  std::string_view name;  //!< of --format
  std::string_view what;  //!< in a few words
  std::function<bool(const std::filesystem::path&)> recognises;
  /** Throws importing::ImportError, formats::FormatError and formats::FileError. */
  std::function<std::unique_ptr<importing::Source>(const ImportCommand&)> open;
};

/** All, those first that recognise the fewest inputs. */
const std::vector<KnownFormat>& knownFormats();
}  // namespace traverse::app
