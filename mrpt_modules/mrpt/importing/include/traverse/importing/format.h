// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/importing/import_params.h>
#include <traverse/importing/source.h>

#include <memory>
#include <span>
#include <string_view>

namespace traverse::importing
{
/** A layout that recordings come in. */
struct Format
{
  std::string_view name;  //!< of --format
  std::string_view what;  //!< in a few words
  /** Looks at names, and no further than it must. */
  bool (*recognises)(const std::filesystem::path& input);
  /** Throws ImportError; FormatError and FileError for files that the whole depends on. */
  std::unique_ptr<Source> (*open)(const ImportParams& params);
};

/** All, those first that recognise the fewest inputs. */
std::span<const Format> allFormats();
}  // namespace traverse::importing
