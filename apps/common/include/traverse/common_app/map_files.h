// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <traverse/layers/scan_consumer.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace mrpt::rtti
{
class CObject;
}  // namespace mrpt::rtti

namespace traverse::app
{
/** The map archives (*.traverse) of an output folder by name, or the one file that is given itself.
 * Throws formats::FormatError where there is none. */
std::vector<std::filesystem::path> mapFiles(const std::filesystem::path& folder_or_file);

/** A map read back from its archive. */
struct LoadedMap
{
  std::string kind;  //!< of the archive (formats/archive.h)
  size_t bytes = 0;  //!< of the archive
  std::shared_ptr<mrpt::rtti::CObject> object;
  layers::ScanConsumer* consumer = nullptr;  //!< the object; never null
};

/** Needs plugin::registerAllMaps(). Throws formats::FormatError, naming the file, for what is no
 * archive, damaged, or of no map of this program. */
LoadedMap loadMap(const std::filesystem::path& file);
}  // namespace traverse::app
