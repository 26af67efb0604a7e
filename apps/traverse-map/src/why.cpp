// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "why.h"

#include <traverse/formats/archive.h>
#include <traverse/formats/safe_file.h>
#include <traverse/layers/scan_consumer.h>
#include <traverse/plugin/schemas.h>

#include <mrpt/rtti/CObject.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <vector>

namespace traverse::app
{
namespace
{
constexpr size_t kLargestMap = size_t{16} << 30U;

std::vector<std::filesystem::path> archivesIn(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
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
        fmt::format("cannot read folder '{}': {}", folder.string(), error.message()));
  }
  if (files.empty())
  {
    throw formats::FormatError(fmt::format("'{}' has no map (*.traverse)", folder.string()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

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

std::string whyIn(const std::filesystem::path& file, const std::array<double, 2>& place_m)
{
  const std::string bytes = formats::readFile(file, kLargestMap);
  const std::string kind = formats::archiveKind(bytes);
  const std::shared_ptr<mrpt::rtti::CObject> map = mapOfKind(kind);
  auto* consumer = dynamic_cast<layers::ScanConsumer*>(map.get());
  if (consumer == nullptr)
  {
    throw formats::FormatError("no map of this program has archives of this kind");
  }
  consumer->setFromArchive(bytes);
  std::string text = fmt::format("map: {}, {}\n", file.filename().string(), kind);
  for (const layers::Fact& fact : consumer->explain(place_m[0], place_m[1]))
  {
    text += fmt::format("{}: {}\n", fact.key, fact.value);
  }
  return text;
}
}  // namespace

std::optional<std::array<double, 2>> parsePlace(std::string_view text)
{
  constexpr double kFarthest_m = 1e6;
  const size_t comma = text.find(',');
  if (comma == std::string_view::npos)
  {
    return std::nullopt;
  }
  std::array<double, 2> place{};
  const std::array<std::string_view, 2> parts = {text.substr(0, comma), text.substr(comma + 1)};
  for (size_t i = 0; i < parts.size(); ++i)
  {
    const char* end = parts[i].data() + parts[i].size();
    const auto [stop, error] = std::from_chars(parts[i].data(), end, place[i]);
    if (error != std::errc() || stop != end || !(std::abs(place[i]) <= kFarthest_m))
    {
      return std::nullopt;
    }
  }
  return place;
}

std::string why(const std::filesystem::path& folder, const std::array<double, 2>& place_m)
{
  std::string text;
  for (const std::filesystem::path& file : archivesIn(folder))
  {
    try
    {
      text += (text.empty() ? "" : "\n") + whyIn(file, place_m);
    }
    catch (const std::runtime_error& e)
    {
      throw formats::FormatError(fmt::format("'{}': {}", file.string(), e.what()));
    }
  }
  return text;
}
}  // namespace traverse::app
