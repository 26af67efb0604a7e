// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/common_app/map_set.h>

#include <mrpt/config/CConfigFileMemory.h>

#include <fmt/format.h>
#include <memory>
#include <regex>

namespace traverse::app
{
namespace
{
using config::ConfigError;

/** The maps of one name, as MRPT's factory makes them from its `name_count` key. */
std::vector<mrpt::maps::CMetricMap::Ptr> make(
    const config::IniDocument& ini, const WantedMap& wanted)
{
  config::IniDocument only = ini;
  for (const config::Entry& entry : ini.entries())
  {
    if (config::sameName(entry.section, "Maps"))
    {
      const bool this_one = config::sameName(entry.key, wanted.name + "_count");
      only.set(fmt::format("Maps.{}={}", entry.key, this_one ? wanted.count : 0));
    }
  }
  mrpt::maps::TSetOfMetricMapInitializers initializers;
  initializers.loadFromConfigFile(mrpt::config::CConfigFileMemory(only.text()), "Maps");
  mrpt::maps::CMultiMetricMap made;
  made.setListOfMaps(initializers);
  return {made.maps.begin(), made.maps.end()};
}

/** The message of an exception that MRPT has wrapped into a report with addresses. */
std::string plainMessage(const std::string& what)
{
  std::string text = what;
  for (const std::string mark : {"==== MRPT exception ====\n", "Message:"})
  {
    if (text.rfind(mark, 0) == 0)
    {
      text.erase(0, mark.size());
    }
  }
  text.erase(0, text.find_first_not_of(' '));
  return text.substr(0, text.find('\n'));
}

/** "section NAME: key = ..." with the place of that key in front, where it stands in the ini. */
std::string withPlace(const std::string& message, const config::IniDocument& ini)
{
  static const std::regex kKey("section (\\S+): (\\w+) = .*");
  std::smatch match;
  const config::Entry* entry =
      std::regex_match(message, match, kKey) ? ini.find(match[1].str(), match[2].str()) : nullptr;
  return entry == nullptr ? message : fmt::format("{}: {}", entry->place, message);
}

/** Adds the maps of one name; all of them, or ConfigError. */
void addMaps(const config::IniDocument& ini, const WantedMap& wanted, std::vector<BuiltMap>& built)
{
  const auto maps = make(ini, wanted);
  if (maps.size() != static_cast<size_t>(wanted.count))
  {
    throw ConfigError(fmt::format(
        "[Maps] asks for {} {}, and MRPT's factory made {}", wanted.count, wanted.name,
        maps.size()));
  }
  for (size_t i = 0; i < maps.size(); ++i)
  {
    auto* consumer = dynamic_cast<layers::ScanConsumer*>(maps[i].get());
    if (consumer == nullptr)
    {
      throw ConfigError(fmt::format("[Maps] {} takes no scans", wanted.name));
    }
    built.push_back({wanted.name, i == 0 ? "" : fmt::format("_{:02}", i), maps[i], consumer});
  }
}
}  // namespace

geometry::Lattice latticeOf(const BuiltMap& map)
{
  return map.consumer->layerSet(geometry::CellRect{{0, 0}, {1, 1}}, {std::vector<std::string>{}})
      .lattice;
}

std::vector<BuiltMap> buildMaps(
    const config::IniDocument& ini, const std::vector<WantedMap>& wanted)
{
  std::vector<BuiltMap> built;
  for (const WantedMap& some : wanted)
  {
    try
    {
      addMaps(ini, some, built);
    }
    catch (const ConfigError&)
    {
      throw;
    }
    catch (const std::exception& e)
    {
      throw ConfigError(withPlace(plainMessage(e.what()), ini));
    }
  }
  return built;
}
}  // namespace traverse::app
