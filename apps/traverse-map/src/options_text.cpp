// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include "settings.h"

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

std::vector<Section> allSections()
{
  std::vector<Section> all = {
      {"traverse-map", "The run.", options::rows(RunParams{})},
      {"Vehicle", "What drives; all maps use it.", options::rows(geometry::Vehicle{})},
      {"Poses", "Where the poses come from.", options::rows(poses::PoseParams{})},
      {"Sensors", "How observations become points.",
       options::rows(observations::ObservationParams{})},
      {"Log", "How the log is read.", options::rows(logs::LogParams{})}};
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
}  // namespace

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
