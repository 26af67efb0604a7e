// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/wanted_maps.h>
#include <traverse/config/strict.h>
#include <traverse/plugin/schemas.h>

#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include <algorithm>
#include <fmt/format.h>

namespace traverse::app
{
namespace
{
using config::ConfigError;
using config::sameName;

constexpr std::string_view kCount = "_count";

std::vector<std::string> ownNames()
{
  std::vector<std::string> names;
  for (const plugin::MapSchema& schema : plugin::mapSchemas())
  {
    names.push_back(schema.name);
    names.insert(names.end(), schema.aliases.begin(), schema.aliases.end());
  }
  return names;
}

bool isOneOf(const std::string& name, const std::vector<std::string>& names)
{
  return std::any_of(
      names.begin(), names.end(), [&](const std::string& n) { return sameName(n, name); });
}

std::vector<std::string> stockNames()
{
  std::vector<std::string> names;
  for (const auto& [name, functions] :
       mrpt::maps::internal::TMetricMapTypesRegistry::Instance().getAllRegistered())
  {
    names.push_back(name);
  }
  return names;
}

int countOf(const config::Entry& entry)
{
  int count = 0;
  try
  {
    options::parse({entry.key, "", {0, 16}}, entry.value, count);
  }
  catch (const options::OptionError& e)
  {
    throw ConfigError(fmt::format("{}: [Maps] {}", entry.place, e.what()));
  }
  return count;
}

[[noreturn]] void refuse(const config::Entry& entry)
{
  std::vector<std::string> keys;
  for (const std::string& name : ownNames())
  {
    keys.push_back(name + std::string(kCount));
  }
  const std::string near = options::nearest(entry.key, keys);
  throw ConfigError(fmt::format(
      "{}: [Maps] unknown key '{}'; {}", entry.place, entry.key,
      near.empty() ? fmt::format("known: {}", fmt::join(keys, ", "))
                   : fmt::format("did you mean '{}'?", near)));
}

/** Calls f(name, schema) for every ini section of a wanted map. */
template <class F>
void forEachSection(const WantedMap& map, F&& f)
{
  for (const plugin::MapSchema& schema : plugin::mapSchemas())
  {
    if (!sameName(schema.name, map.name) && !isOneOf(map.name, schema.aliases))
    {
      continue;
    }
    for (int i = 0; i < map.count; ++i)
    {
      for (const plugin::SectionSchema& section : schema.sections)
      {
        f(fmt::format("Maps_{}_{:02}_{}", map.name, i, section.suffix), section);
      }
    }
  }
}

void checkEntry(const config::Entry& entry, const plugin::SectionSchema& section)
{
  try
  {
    section.check(entry.section, entry.key, entry.value);
  }
  catch (const ConfigError& e)
  {
    throw ConfigError(fmt::format("{}: {}", entry.place, e.what()), e.section(), e.key());
  }
}

void checkMapSections(const WantedMap& map, const config::IniDocument& ini)
{
  forEachSection(
      map,
      [&](const std::string& name, const plugin::SectionSchema& section)
      {
        for (const config::Entry& entry : ini.entries())
        {
          if (sameName(entry.section, name))
          {
            checkEntry(entry, section);
          }
        }
      });
}
}  // namespace

std::vector<std::string> mapSections(const WantedMap& map)
{
  std::vector<std::string> sections;
  forEachSection(
      map, [&](const std::string& name, const auto& /*section*/) { sections.push_back(name); });
  return sections;
}

MapWishes readWantedMaps(const config::IniDocument& ini)
{
  MapWishes wishes;
  for (const config::Entry& entry : ini.entries())
  {
    if (!sameName(entry.section, "Maps"))
    {
      continue;
    }
    const size_t stem = entry.key.size() > kCount.size() ? entry.key.size() - kCount.size() : 0;
    if (stem == 0 || !sameName(entry.key.substr(stem), kCount))
    {
      refuse(entry);
    }
    const WantedMap map{entry.key.substr(0, stem), countOf(entry)};
    if (isOneOf(map.name, ownNames()))
    {
      wishes.ours.push_back(map);
    }
    else if (isOneOf(map.name, stockNames()))
    {
      wishes.stock.push_back(map);
      wishes.warnings.push_back(fmt::format(
          "{}: {} is a stock MRPT map: left to MRPT's own programs, not built here", entry.place,
          map.name));
    }
    else
    {
      refuse(entry);
    }
  }
  const bool any = std::any_of(
      wishes.ours.begin(), wishes.ours.end(), [](const WantedMap& m) { return m.count > 0; });
  if (!any)
  {
    throw ConfigError(fmt::format(
        "[Maps] asks for no map; write e.g. {}_count = 1",
        ownNames().empty() ? "?" : ownNames().front()));
  }
  for (const WantedMap& map : wishes.ours)
  {
    checkMapSections(map, ini);
  }
  return wishes;
}

namespace
{
/** A section that a map which is counted in [Maps] reads. */
bool isOfAWantedMap(const std::string& section, const std::vector<WantedMap>& maps)
{
  for (const WantedMap& map : maps)
  {
    for (const std::string& own : mapSections(map))
    {
      if (sameName(own, section))
      {
        return true;
      }
    }
  }
  return false;
}

/** [Maps_<map>_...] of a stock map: which sections it reads is MRPT's business. */
bool isOfAStockMap(const std::string& section, const std::vector<WantedMap>& maps)
{
  for (const WantedMap& map : maps)
  {
    const std::string prefix = fmt::format("Maps_{}_", map.name);
    if (section.size() > prefix.size() && sameName(section.substr(0, prefix.size()), prefix))
    {
      return true;
    }
  }
  return false;
}

const config::Entry& firstEntry(const config::IniDocument& ini, const std::string& section)
{
  for (const config::Entry& e : ini.entries())
  {
    if (sameName(e.section, section))
    {
      return e;
    }
  }
  throw std::logic_error("a section without entries");
}

}  // namespace

void checkSections(
    const config::IniDocument& ini, const std::vector<std::string>& own, MapWishes& wishes)
{
  for (const std::string& section : ini.sections())
  {
    if (isOneOf(section, own) || isOfAWantedMap(section, wishes.ours))
    {
      continue;
    }
    const std::string place = firstEntry(ini, section).place;
    if (isOfAStockMap(section, wishes.stock))
    {
      wishes.warnings.push_back(
          fmt::format("{}: [{}] belongs to a stock MRPT map: not checked", place, section));
      continue;
    }
    std::vector<std::string> known = own;
    for (const WantedMap& map : wishes.ours)
    {
      const auto more = mapSections(map);
      known.insert(known.end(), more.begin(), more.end());
    }
    const std::string near = options::nearest(section, known);
    throw ConfigError(fmt::format(
        "{}: unknown section [{}]; {}", place, section,
        near.empty() ? fmt::format("known: [{}]", fmt::join(known, "], ["))
                     : "did you mean [" + near + "]?"));
  }
}

}  // namespace traverse::app
