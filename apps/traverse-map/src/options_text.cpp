// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

#include <traverse/common_app/wanted_maps.h>

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace traverse::app
{
namespace
{
struct Section
{
  std::string name;
  std::string meaning;
  std::vector<options::Row> rows;
};

/** The app's own sections with the values of these settings. */
std::vector<Section> ownSections(const Settings& s)
{
  return {
      {"traverse-map", "The run.", options::rows(s.run)},
      {"Vehicle", "What drives; all maps use it.", options::rows(s.vehicle)},
      {"Poses", "Where the poses come from.", options::rows(s.poses)},
      {"Sensors", "How observations become points.", options::rows(s.sensors)},
      {"Log", "How the log is read.", options::rows(s.log)}};
}

std::vector<Section> allSections()
{
  std::vector<Section> all = ownSections({});
  Section maps{"Maps", "Which maps are built, by MRPT's own mechanism.", {}};
  for (const plugin::MapSchema& schema : plugin::mapSchemas())
  {
    maps.rows.push_back({schema.name + "_count", "1", "int", "0 to 16", "how many of this map"});
  }
  all.push_back(maps);
  for (const plugin::MapSchema& schema : plugin::mapSchemas())
  {
    for (const plugin::SectionSchema& section : schema.sections)
    {
      all.push_back(
          {fmt::format("Maps_{}_00_{}", schema.name, section.suffix), section.meaning,
           section.rows});
    }
  }
  return all;
}

std::string escaped(const std::string& cell)
{
  std::string out;
  for (const char c : cell)
  {
    out += c == '|' ? "\\|" : std::string(1, c);
  }
  return out;
}

std::string absolutePath(const std::string& name)
{
  return name.empty() ? name : std::filesystem::absolute(name).lexically_normal().string();
}

/** One line, whatever came by --set. */
std::string line(const std::string& key, const std::string& value)
{
  std::string text = fmt::format("{} = {}", key, value);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text + "\n";
}
}  // namespace

std::string configIni(const Settings& settings)
{
  Settings s = settings;
  s.run.rawlog = s.rebuild.empty() ? absolutePath(s.rawlog.string()) : "";
  s.run.output = absolutePath(s.output.string());
  s.poses.file = absolutePath(s.poses.file);
  s.poses.times_file = absolutePath(s.poses.times_file);
  std::string text = "// What this folder was made with.\n";
  if (!s.rebuild.empty())
  {
    text += "// And --rebuild, not a log.\n";
  }
  for (const Section& section : ownSections(s))
  {
    text += fmt::format("\n[{}]\n", section.name);
    for (const options::Row& row : section.rows)
    {
      text += line(row.key, row.value);
    }
  }
  text += "\n[Maps]\n";
  for (const WantedMap& map : s.maps)
  {
    text += line(map.name + "_count", std::to_string(map.count));
  }
  for (const WantedMap& map : s.maps)
  {
    for (const std::string& section : mapSections(map))
    {
      text += fmt::format("\n[{}]\n", section);
      for (const config::Entry& entry : s.ini.entries())
      {
        text += config::sameName(entry.section, section) ? line(entry.key, entry.value) : "";
      }
    }
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> recipe(const Settings& settings)
{
  std::vector<std::pair<std::string, std::string>> entries = {
      {"[traverse-map] deskew", options::format(settings.run.deskew)}};
  for (const Section& section : ownSections(settings))
  {
    if (section.name == "traverse-map" || section.name == "Log")
    {
      continue;
    }
    for (const options::Row& row : section.rows)
    {
      const bool is_file =
          section.name == "Poses" && (row.key == "file" || row.key == "times_file");
      if (!is_file)  // what stands in it counts, not where it lies
      {
        entries.emplace_back(fmt::format("[{}] {}", section.name, row.key), row.value);
      }
    }
  }
  for (const WantedMap& map : settings.maps)
  {
    entries.emplace_back("[Maps] " + map.name + "_count", std::to_string(map.count));
  }
  return entries;
}

std::string defaultsIni()
{
  std::string text =
      "// Every key of traverse-map with its default. Generated: traverse-map --print-defaults\n"
      "// A key that is left out has the value that stands here. doc/options.md has the same as "
      "tables.\n";
  for (const Section& section : allSections())
  {
    text += fmt::format("\n// {}\n[{}]\n", section.meaning, section.name);
    for (const options::Row& row : section.rows)
    {
      const std::string allowed = row.type == "text" ? "" : fmt::format(" ({})", row.allowed);
      text += fmt::format("// {}{}\n{} = {}\n", row.meaning, allowed, row.key, row.value);
    }
  }
  return text;
}

std::string optionTables()
{
  std::string text =
      "# Options of traverse-map\n\n"
      "Generated: `traverse-map --print-options`. A wrong key or value is refused with its file "
      "and line.\n";
  for (const Section& section : allSections())
  {
    text += fmt::format(
        "\n## [{}]\n\n{}\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n",
        section.name, section.meaning);
    for (const options::Row& row : section.rows)
    {
      text += fmt::format(
          "| `{}` | {} | {} | {} |\n", row.key,
          row.value.empty() ? "" : "`" + escaped(row.value) + "`", escaped(row.allowed),
          escaped(row.meaning));
    }
  }
  return text;
}
}  // namespace traverse::app
