// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/map_files.h>
#include <traverse/formats/archive.h>
#include <traverse/formats/safe_file.h>
#include <traverse/plugin/schemas.h>

#include <mrpt/rtti/CObject.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
constexpr size_t kLargestMap = size_t{16} << 30U;

/** A new map of the class that an archive of this kind is of; nullptr where there is none. */
std::shared_ptr<mrpt::rtti::CObject> mapOfKind(std::string_view kind)
{
  for (const plugin::MapSchema& schema : plugin::mapSchemas())
  {
    for (const std::string& name : schema.aliases)
    {
      const mrpt::rtti::TRuntimeClassId* type = mrpt::rtti::findRegisteredClass(name);
      std::shared_ptr<mrpt::rtti::CObject> map = type == nullptr ? nullptr : type->createObject();
      const auto* consumer = dynamic_cast<layers::ScanConsumer*>(map.get());
      if (consumer != nullptr && consumer->archiveKind() == kind)
      {
        return map;
      }
    }
  }
  return nullptr;
}

LoadedMap load(const std::filesystem::path& file)
{
  const std::string bytes = formats::readFile(file, kLargestMap);
  LoadedMap loaded{formats::archiveKind(bytes), bytes.size(), nullptr, nullptr};
  loaded.object = mapOfKind(loaded.kind);
  loaded.consumer = dynamic_cast<layers::ScanConsumer*>(loaded.object.get());
  if (loaded.consumer == nullptr)
  {
    throw formats::FormatError("no map of this program has archives of this kind");
  }
  loaded.consumer->setFromArchive(bytes);
  return loaded;
}
}  // namespace

std::vector<std::filesystem::path> mapFiles(const std::filesystem::path& folder_or_file)
{
  std::error_code error;
  if (std::filesystem::is_regular_file(folder_or_file, error))
  {
    return {folder_or_file};
  }
  std::vector<std::filesystem::path> files;
  error.clear();
  for (std::filesystem::directory_iterator it(folder_or_file, error), end; !error && it != end;
       it.increment(error))
  {
    if (it->path().extension() == ".traverse")
    {
      files.push_back(it->path());
    }
  }
  if (error)
  {
    throw formats::FormatError(
        fmt::format("cannot read folder '{}': {}", folder_or_file.string(), error.message()));
  }
  if (files.empty())
  {
    throw formats::FormatError(
        fmt::format("'{}' has no map (*.traverse)", folder_or_file.string()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

LoadedMap loadMap(const std::filesystem::path& file)
{
  try
  {
    return load(file);
  }
  catch (const std::runtime_error& e)
  {
    throw formats::FormatError(fmt::format("'{}': {}", file.string(), e.what()));
  }
}
}  // namespace traverse::app
